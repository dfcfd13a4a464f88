#pragma once
#include "measure/surface_measurement.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

// Both passes walk the isolines of a lattice of rays, none of which may have missed (RayHits::hit),
// as Catmull-Rom splines through its hits. kappa > 0 where an isoline curves towards p_u x p_v; the
// normal of a segment is the mean of those at its two ends, cross products of the central
// differences of the lattice.
//
// smoothingWidth (0: none; in the scene's unit of length) takes from rough meshes the creases that
// kappa would follow: the kappa of a segment becomes the Gaussian mean of the segments' means along
// its isoline, with weights length x exp(-d^2 / (2 sigma^2)), sigma = smoothingWidth / 2, d the arc
// length (chords) between the segments' middles. At an isoline's ends the weights that are left add
// up to 1 too.
//
// Both throw InputError when neighbouring rays hit the same point.

/// First pass over a mesh's hits.
struct MeshSurvey {
  /// Lengths are sums of chords; kappa: 10 samples a segment, or, smoothed, one.
  SurfaceSurvey survey;

  /// The median, over all pairs of neighbouring segments of an isoline, of the difference between
  /// their means of kappa, smoothed where that is asked for; 1 / length, >= 0. 0 without
  /// neighbours.
  double curvatureNoise;
};
MeshSurvey surveyMesh(const RayHits& hits, double smoothingWidth);

/// Second pass: one isoline a line of vertices, hits.countU = nodesU + 1, hits.countV = nodesV + 1.
/// kappa of a strut is the mean of 100 samples of its segment, smoothed where that is asked for,
/// then capped to curvatureLimit. Not each sample, as on a patch: the few samples on a crease carry
/// the bend of the facets beside it.
SurfaceMeasurement measureMesh(const RayHits& hits, double curvatureLimit, double smoothingWidth);

}  // namespace morphgrid
