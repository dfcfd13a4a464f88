#pragma once
#include "app/scene.h"

namespace morphgrid {

/// How rays sampled a mesh in the first pass.
struct MeshSampling {
  RayHits hits;
  MeshFigures figures;
};

/// The inverse design of a scene, and what was measured for it.
struct SceneDesign {
  GridDesign design;
  std::optional<MeasurementFigures> measurement;  ///< Not for grids given by bend angles.
  std::optional<NetFigures> net;                  ///< As above.
  std::optional<Eigen::Matrix3Xd> targets;  ///< Of the middle layer's vertices, in index order.
  std::optional<MeshSampling> sampling;     ///< Only of meshes.
  std::vector<std::string> notices;         ///< What was clamped or overridden.
};

/// Measures the surface and designs the grid. Throws InputError when they cannot be had, Cancelled
/// when scene.solve is requested to stop.
SceneDesign designScene(const Scene& scene);

/// As scene files call them.
const char* nameOf(Method method);
const char* nameOf(Scaling scaling);

/// What there is to report before anything is solved.
RunRecord recordOf(const Scene& scene, const SceneDesign& designed);

}  // namespace morphgrid
