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

/// Layers at equal distances from their neighbours, around the middle.
struct LayerStack {
  int layers;
  double spacing;        ///< tau
  double barHeight = 0;  ///< Of bars that resist being bent, >= 0

  double height(int layer) const { return (layer - (layers - 1) / 2.0) * spacing; }
};

/// Rest lengths of each layer, bottom first, with the target in the middle: in layer k, at height h
/// along the normals, struts rest at the chords between p + h N at their ends. Against bars' own
/// resistance they differ from the middle's by `1 + layers barHeight^2 / (12 sum h^2)` times as
/// much. points, normals: 3 x layerVertexCount of the layer's shape.
std::vector<LateralField<double>> lengthsOnOffsets(const GridShape& layer,
                                                   const Eigen::Matrix3Xd& points,
                                                   const Eigen::Matrix3Xd& normals,
                                                   const LayerStack& stack);

/// The design of those lengths. L0 is the longest of a strut's, theta follows from the difference
/// between the bottom and the top layer. normals: unit, of the target at measurement.points; theta
/// > 0 where the target curves towards them. Throws InputError, with a tau that is too large, where
/// a strut would have no length left.
GridDesign designOnOffsets(const SurfaceMeasurement& measurement, const Eigen::Matrix3Xd& normals,
                           const LayerStack& stack);

/// Normals of a net whose points have moved: those of before, turned at each vertex as the net
/// has. All 3 x layerVertexCount.
Eigen::Matrix3Xd carryNormals(const GridShape& layer, const Eigen::Matrix3Xd& before,
                              const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& after);

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
