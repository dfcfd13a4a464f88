#pragma once
#include <optional>
#include <string>
#include <vector>

#include "design/grid_size.h"

namespace morphgrid {

/// Everything needed to print and to morph: lengths per lateral strut, bend angle, size.
struct GridDesign {
  int nodesU;
  int nodesV;
  int layers;
  double layerSpacing;           ///< tau
  double spacing;                ///< Cell of the flat sheet before the in-plane stage.
  LateralField<double> lengths;  ///< L0, of the layer where the strut is longest: the convex side.
  LateralField<double> bendAngles;  ///< Signed theta, rad, in [-pi, pi]; > 0 curves towards +w.
  /// Rest lengths of each layer, bottom first, > 0; L0 at most.
  std::vector<LateralField<double>> rest;
  std::vector<std::string> notices;
};

/// The paper's: each strut's convex side has the chord of the target for its length.
/// theta = 2 asin(L0 kappa / 2) (Eq. 24); the sine is clamped to 1, with a notice.
GridDesign designGrid(const SurfaceMeasurement& measurement, const GridSize& size, int layers);

/// With the target in the middle of the layers: in layer k, at height h = (k - (layers - 1) / 2)
/// tau along the normals, struts rest at the chords between p + h N at their ends. L0 is the
/// longest of them, theta follows from the difference between the bottom and the top layer.
/// normals: 3 x (nodesU+1)(nodesV+1), unit, of the target at measurement.points; theta > 0 where
/// the target curves towards them. barHeight, >= 0: bars as high as that resist being bent, so that
/// lengths differ by `1 + layers barHeight^2 / (12 sum h^2)` times as much between layers. Throws
/// InputError, with a tau that is too large, where a strut would have no length left.
GridDesign designOnOffsets(const SurfaceMeasurement& measurement, const Eigen::Matrix3Xd& normals,
                           const GridSize& size, int layers, double barHeight = 0);


/// Straight from bend angles, for surfaces that are given by how they bend (Fig. 1(c)).
/// theta runs linearly from the first to the last strut of each row.
struct BendAngleRequest {
  int nodesU = 1;
  int nodesV = 1;
  double spacing = 1;                      ///< Side of a cell of the flat sheet, > 0
  double firstThetaU = 0, lastThetaU = 0;  ///< rad
  double firstThetaV = 0, lastThetaV = 0;  ///< rad

  bool operator==(const BendAngleRequest&) const = default;
};
GridDesign designFromBendAngles(const BendAngleRequest& request, int layers, double layerSpacing);

/// L_n = L0 - 2 n tau sin(|theta|/2), n counted from the layer on the convex side (Eq. 25):
/// the bottom where theta > 0, the top where theta < 0.
double restLength(double length, double bendAngle, double layerSpacing, int layer, int layers);

/// The largest shrink between layers that the design asks for, 1 - rest / L0 over all lateral
/// struts, in [0, 1).
double largestBendShrink(const GridDesign& design);

}  // namespace morphgrid
