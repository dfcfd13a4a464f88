#pragma once
#include <filesystem>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Reads a mesh file: OBJ, STL (binary, ASCII), PLY (binary, ASCII), glTF or GLB, told apart by
/// extension. Polygons are triangulated, the node transforms of glTF applied, all its meshes
/// joined. Throws InputError, `file: what is wrong and where`, when the file is broken or holds no
/// triangle; memory stays in proportion to the file's size.
TriangleMesh loadMesh(const std::filesystem::path& file);

/// Whether a file is called like a mesh, by its extension.
bool isMeshName(const std::filesystem::path& file);

}  // namespace morphgrid
