#pragma once
#include "measure/surface_measurement.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// First pass over a mesh's hits; none may be missing. Catmull-Rom splines along the isolines give
/// lengths (chords) and curvature, 10 samples a segment.
struct MeshSurvey {
  SurfaceSurvey survey;
  double
      curvatureNoise;  ///< Median |difference| of kappa between neighbouring segments, 1 / length.
};

/// smoothingWidth: standard width (two sigma) of the Gaussian along the isoline that smooths kappa,
/// in the scene's unit of length; 0 for none. Throws InputError when there is no extent.
MeshSurvey surveyMesh(const RayHits& hits, double smoothingWidth);

/// Second pass: one isoline a line of vertices, hits.countU = nodesU + 1, hits.countV = nodesV + 1;
/// kappa of a strut is the mean of 100 samples of its segment, capped to curvatureLimit.
SurfaceMeasurement measureMesh(const RayHits& hits, double curvatureLimit, double smoothingWidth);

}  // namespace morphgrid
