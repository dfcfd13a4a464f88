#pragma once
#include <filesystem>

#include "grid/surface_mesh.h"

namespace morphgrid {

// Vertices read back as the same doubles. Both throw InputError naming the path when the disk
// refuses.

/// Binary PLY: vertices with double x y z and float nx ny nz, triangles as vertex_indices.
void exportPly(const std::filesystem::path& path, const SurfaceMesh& surface);

/// OBJ, text: v, vn, and triangles as f a//a b//b c//c.
void exportObj(const std::filesystem::path& path, const SurfaceMesh& surface);

}  // namespace morphgrid
