#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Reads bytes as a file of that name.
TriangleMesh meshOf(const std::string& name, std::string_view bytes);

/// The notices of doing so, a line each.
std::string noticesOf(const std::string& name, std::string_view bytes);

/// The error of doing so; empty when there is none.
std::string problemOf(const std::string& name, std::string_view bytes);

/// The error of loading a file of the disk; empty when there is none.
std::string problemOfFile(const std::filesystem::path& file);

/// Area of all triangles: a sound triangulation of a flat polygon has the polygon's.
double areaOf(const TriangleMesh& mesh);

/// The text with other ends of its lines.
std::string withLineEnds(std::string_view text, std::string_view end);

/// A value's bytes, as this machine has them.
template <typename... Values>
std::string bytesOf(Values... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
  return bytes;
}

}  // namespace morphgrid
