#pragma once
#include "measure/surface_measurement.h"
#include "surface/point_lattice.h"

namespace morphgrid {

// Both passes walk the lines of a lattice of points as Catmull-Rom splines: the isolines of a mesh
// through the hits of rays, or the lines of any net on a target. kappa > 0 where a line curves
// towards p_u x p_v; the normal of a segment is the mean of those at its two ends, cross products
// of the central differences of the lattice.
//
// smoothingWidth (0: none; in the scene's unit of length) takes from rough meshes the creases that
// kappa would follow: the kappa of a segment becomes the Gaussian mean of the segments' means along
// its isoline, with weights length x exp(-d^2 / (2 sigma^2)), sigma = smoothingWidth / 2, d the arc
// length (chords) between the segments' middles. At an isoline's ends the weights that are left add
// up to 1 too.
//
// Both throw InputError when neighbouring points coincide.

/// First pass.
struct LatticeSurvey {
  /// Lengths are sums of chords; kappa: 10 samples a segment, or, smoothed, one.
  SurfaceSurvey survey;

  /// The median, over all pairs of neighbouring segments of an isoline, of the difference between
  /// their means of kappa, smoothed where that is asked for; 1 / length, >= 0. 0 without
  /// neighbours.
  double curvatureNoise;
};
LatticeSurvey surveyLattice(const PointLattice& lattice, double smoothingWidth,
                            const Cancellation& cancellation = {});

/// Second pass: a line of the lattice is a line of vertices, countU = nodesU + 1, countV = nodesV +
/// 1. kappa of a strut is the mean of 100 samples of its segment, smoothed where that is asked for,
/// then capped to curvatureLimit. Not each sample, as on the isolines of a patch: the few samples
/// on a mesh's crease carry the bend of the facets beside it.
SurfaceMeasurement measureLattice(const PointLattice& lattice, double curvatureLimit,
                                  double smoothingWidth, const Cancellation& cancellation = {});

}  // namespace morphgrid
