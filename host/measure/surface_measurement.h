#pragma once
#include <Eigen/Core>
#include <vector>

#include "core/cancellation.h"
#include "grid/lateral_field.h"
#include "surface/surface.h"

namespace morphgrid {

/// First pass over a surface: its extents and curvature, before any grid is chosen.
struct SurfaceSurvey {
  double longestIsolineU;  ///< Length of the longest isoline along u.
  double longestIsolineV;
  double largestCurvatureU;  ///< Largest |kappa| along u, in 1 / length.
  double largestCurvatureV;
  std::vector<double> sortedCurvatures;  ///< All |kappa|, ascending.

  double largestCurvature() const { return sortedCurvatures.back(); }
};

/// What the isolines of one direction have.
struct DirectionSurvey {
  double longestIsoline = 0;
  double largestCurvature = 0;  ///< The largest abs(kappa), 1 / length.
};

/// curvatures: all |kappa|, in any order, at least one. Throws InputError when there is no extent
/// along u or v.
SurfaceSurvey makeSurvey(const DirectionSurvey& u, const DirectionSurvey& v,
                         std::vector<double> curvatures);

/// Walks 100 isolines in u and in v with 1000 samples each (paper, section 3.2).
/// Throws InputError when the surface has no extent along u or v.
SurfaceSurvey surveySurface(const Surface& surface, const Cancellation& cancellation = {});

/// kappa_max: |kappa| sorted, at index floor((n-1) cutoff); cutoff in (0, 1].
double curvatureAtCutoff(const SurfaceSurvey& survey, double cutoff);

/// Points and unit normals of the surface at the parameters (u, v), 2 x n: 3 x n each.
Eigen::Matrix3Xd pointsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters);
Eigen::Matrix3Xd normalsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters);

/// Second pass, at node size: one length and curvature for each lateral strut.
struct SurfaceMeasurement {
  int nodesU;
  int nodesV;
  LateralField<double> chords;      ///< Straight distance between a strut's end points.
  LateralField<double> curvatures;  ///< Signed kappa, mean of samples along a strut, capped.
  Eigen::Matrix3Xd points;  ///< Target of each vertex of the middle layer, index j (nodesU+1) + i.
};

/// Along the isolines, with 100 samples a strut as in the paper, fewer where an isoline has more
/// than 100 struts. Every |kappa| sample is capped to curvatureLimit before the mean is taken.
SurfaceMeasurement measureSurface(const Surface& surface, int nodesU, int nodesV,
                                  double curvatureLimit, const Cancellation& cancellation = {});

}  // namespace morphgrid
