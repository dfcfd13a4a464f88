#pragma once
#include "surface/mesh_source.h"
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Reads the bytes of a file in the format that its extension names; loadMesh without the disk,
/// but for the buffers of a glTF file. Errors as loadMesh.
TriangleMesh readMesh(const MeshSource& source);

/// The readers of the formats. Indices are in range; the rest readMesh checks.
TriangleMesh readObj(const MeshSource& source);
TriangleMesh readStl(const MeshSource& source);
TriangleMesh readPly(const MeshSource& source);
TriangleMesh readGltf(const MeshSource& source);

}  // namespace morphgrid
