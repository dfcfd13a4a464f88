#pragma once
#include <filesystem>

#include "surface/noted_mesh.h"

namespace morphgrid {

/// Reads a mesh file: OBJ, STL (binary, ASCII), PLY (binary, ASCII), glTF or GLB, told apart by
/// extension. Polygons are triangulated; of a glTF file all meshes are joined as its scene shows
/// them: nodes moved, joints posed, default morph weights applied. Throws InputError, `file: what
/// is wrong and where`, when the file is broken or holds no triangle; memory stays in proportion to
/// the file's size.
NotedMesh loadMesh(const std::filesystem::path& file);

/// Whether the file's name ends as those that loadMesh reads.
bool isMeshName(const std::filesystem::path& file);

}  // namespace morphgrid
