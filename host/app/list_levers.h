#pragma once
#include <string>
#include <vector>

#include "app/design_scene.h"
#include "propose/sight.h"

namespace morphgrid {

/// What of a mesh's scene would help most, each tried by design alone, with what it gives: the
/// other net, a box without steep slopes, subdivision. A sentence each; none where nothing helps,
/// or for other surfaces. Throws Cancelled where the scene asks for it.
std::vector<std::string> listLevers(const Scene& scene, const SceneDesign& designed);

/// The sides of a scene's mesh as it is configured; rays look along its +x.
struct MeshSides {
  TriangleMesh mesh;                ///< coarsened()
  std::vector<SightRating> sights;  ///< The best first.
};
MeshSides lookAtMesh(const Scene& scene);

/// Where another side shows a much larger box than the one that rays look at: the transform for it.
std::vector<std::string> adviseOnSides(const std::vector<SightRating>& sights);

}  // namespace morphgrid
