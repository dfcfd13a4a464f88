#pragma once
#include "surface/mesh_source.h"
#include "surface/noted_mesh.h"

namespace morphgrid {

/// Reads the bytes of a file in the format that its extension names; loadMesh without the disk,
/// but for the buffers of a glTF file. Errors as loadMesh.
NotedMesh readMesh(const MeshSource& source);

/// The readers of the formats. Indices are in range; the rest readMesh checks.
NotedMesh readObj(const MeshSource& source);
NotedMesh readStl(const MeshSource& source);
NotedMesh readPly(const MeshSource& source);
NotedMesh readGltf(const MeshSource& source);

}  // namespace morphgrid
