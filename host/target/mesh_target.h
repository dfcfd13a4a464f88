#pragma once
#include "surface/mesh_ray_caster.h"
#include "surface/noted_mesh.h"
#include "target/target.h"
#include "target/target_request.h"

namespace morphgrid {

/// A mesh as its configuration moves it, ready for rays: requests that differ in their boxes may
/// share it.
struct PlacedMesh {
  explicit PlacedMesh(NotedMesh moved);

  TriangleMesh mesh;
  std::vector<std::string> notices;  ///< How it came about; each begins with the file's name.
  Eigen::AlignedBox3d extent;        ///< Without debris, see mainExtent().
  double secondsBuild = 0;           ///< Wall time of building the caster.
  MeshRayCaster caster;
};

/// Subdivides a mesh that was loaded from the configuration's file, and moves it. Throws
/// InputError, with the file, when it cannot be subdivided.
std::shared_ptr<const PlacedMesh> placeMesh(const NotedMesh& loaded,
                                            const MeshConfiguration& configuration);

/// As loadMeshTarget(), of a mesh that is there; the request's configuration is that of `placed`.
std::shared_ptr<const Target> makeMeshTarget(const std::shared_ptr<const PlacedMesh>& placed,
                                             const MeshRequest& request,
                                             const Cancellation& cancellation = {});

/// Loads a mesh, subdivides it, and surveys the part of it that the box of rays meets. Throws
/// InputError when the mesh cannot be read, and, with the box's place and advice, when there is no
/// box or its rays miss or meet an overhang; Cancelled where that is requested.
std::shared_ptr<const Target> loadMeshTarget(const MeshRequest& request,
                                             const Cancellation& cancellation = {});

}  // namespace morphgrid
