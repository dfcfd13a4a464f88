#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measure/surface_measurement.h"

namespace morphgrid {

/// What the user asks of a grid (paper, section 3.1).
struct DesignRequest {
  int layers = 3;                ///< >= 1
  double layerSpacing = 0;       ///< tau, in the scene's unit of length, > 0
  int nodesLong = 20;            ///< Nodes along the longer direction, >= 1
  double maxShrinkage = 0.4;     ///< Share of its printed length that a strut can lose, in (0, 1)
  double curvatureCutoff = 1.0;  ///< p, in (0, 1]: share of the |kappa| samples left uncapped
  std::optional<double> strutThickness;  ///< As printed, in the scene's unit of length, > 0
};

/// The size of a grid, chosen from the survey (Eqs. 21 - 23).
struct GridSize {
  int nodesU;
  int nodesV;
  double layerSpacing;
  double curvatureLimit;     ///< kappa_max after the cutoff, in 1 / length, >= 0
  double layerSpacingLimit;  ///< R maxShrinkage / (layers-1); infinite for flat surfaces or 1 layer
  int fewestNodes;           ///< Eq. 23, along the longer direction, >= 1
  std::vector<std::string> notices;  ///< What was clamped or overridden, for the user.
};

GridSize chooseGridSize(const SurfaceSurvey& survey, const DesignRequest& request);

/// Everything needed to print and to morph: lengths per lateral strut, bend angle, size.
struct GridDesign {
  int nodesU;
  int nodesV;
  int layers;
  double layerSpacing;              ///< tau
  double spacing;                   ///< Cell of the flat sheet before the in-plane stage.
  LateralField<double> lengths;     ///< L0, carried by the layer on the convex side.
  LateralField<double> bendAngles;  ///< Signed theta, rad, in [-pi, pi]; > 0 curves towards +w.
  std::vector<std::string> notices;
};

/// theta = 2 asin(L0 kappa / 2) (Eq. 24); the sine is clamped to 1, and the user told.
GridDesign designGrid(const SurfaceMeasurement& measurement, const GridSize& size, int layers);

/// Straight from bend angles, for surfaces that are given by how they bend (Fig. 1(c)).
/// theta runs linearly from the first to the last strut of each row.
struct BendAngleRequest {
  int nodesU;
  int nodesV;
  int layers;
  double layerSpacing;
  double spacing;
  double firstThetaU, lastThetaU;  ///< rad
  double firstThetaV, lastThetaV;  ///< rad
};
GridDesign designFromBendAngles(const BendAngleRequest& request);

/// L_n = L0 - 2 n tau sin(|theta|/2), n counted from the layer on the convex side (Eq. 25):
/// the bottom where theta > 0, the top where theta < 0.
double restLength(double length, double bendAngle, double layerSpacing, int layer, int layers);

/// The largest L_b shrink that the design asks for, 1 - L_b / L0 over all lateral struts, in [0,
/// 1).
double largestBendShrink(const GridDesign& design);

}  // namespace morphgrid
