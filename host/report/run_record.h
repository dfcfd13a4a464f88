#pragma once
#include <optional>
#include <string>
#include <vector>

#include "design/curvature_cutoff.h"
#include "design/grid_design.h"
#include "design/material.h"
#include "grid/strut_grid.h"
#include "inverse/inverse_design.h"
#include "layout/sheet_figures.h"
#include "print/assess_print.h"
#include "report/feasibility.h"
#include "report/figures.h"
#include "report/notice.h"
#include "report/shrink_figures.h"
#include "report/symmetry_figures.h"
#include "report/weight_figures.h"
#include "solve/equilibrium.h"
#include "target/mesh_figures.h"

namespace morphgrid {

/// The figures that the paper prints for a scene, shown beside ours; percent values are percent.
struct PublishedFigures {
  std::string figure;  ///< e.g. "Fig. 4"
  std::optional<double> longestIsolineU, longestIsolineV, largestCurvature;
  std::optional<int> nodesU, nodesV;
  std::optional<double> bendShrinkPercent, l0Percent, lbPercent, anglePercent;
};

/// What was measured on the target, in the scene's unit of length.
struct MeasurementFigures {
  double longestIsolineU;
  double longestIsolineV;
  double largestCurvature;   ///< Before the cutoff.
  double layerSpacingLimit;  ///< Eq. 21; infinite when nothing bends.
  int fewestNodes;           ///< Eq. 23
  std::vector<CutoffConsequence> cutoffs;
  std::optional<double> suggestedCutoff;  ///< Where a cutoff keeps the design as asked for.
  std::optional<double> curvatureNoise;   ///< 1 / length; of meshes only.
};

/// Where the grid's lines run on the target.
struct NetFigures {
  NetKind kind;
  /// Extent along v over that along u of the rectangle that the target maps to.
  std::optional<double> modulus;
  double blend;  ///< Share of the isolines that max_strut_ratio asked for, in [0, 1].
  NetQuality quality;
};

/// The grid that the design chose.
struct GridFigures {
  GridShape shape;
  double spacing;       ///< Side of the cells of the printed sheet, in the scene's unit of length.
  double layerSpacing;  ///< tau, the same.
  double bendShrinkPercent;  ///< The largest shrink between layers that the design asks for.
};

/// What a stage took whose equilibrium a later one has replaced.
struct StageEffort {
  long iterations;
  double seconds;
};

/// Everything that a run or a check reports; a check has no stages.
struct RunRecord {
  std::string scene;
  std::string title;
  std::string method;
  std::string scaling;
  std::string model = "paper";  ///< What struts are to the solver, see Model.
  std::string device;
  double secondsTotal = 0;
  GridFigures grid{};
  std::optional<MeasurementFigures> measurement;  ///< Not for grids given by bend angles.
  std::optional<NetFigures> net;                  ///< Not for grids given by bend angles.
  std::optional<MeshFigures> mesh;                ///< Only for meshes.
  std::optional<SheetFigures> sheet;              ///< Only of Layout::conformal.
  std::optional<Equilibrium> inPlane;
  /// Extents along x and y of the flat sheet that is printed, in the scene's unit.
  std::optional<Eigen::Array2d> printedSheet;
  std::optional<BarSizes> bars;          ///< Not of Model::paper.
  std::optional<PrintAssessment> print;  ///< Only with [print].
  /// How much the sheet that the in-plane stage left is enlarged, see choosePrintScale().
  double printScale = 1;
  std::optional<Equilibrium> full;           ///< Not for grids of one layer.
  std::optional<InverseDesign> inverse;      ///< Its equilibrium is that of `full`.
  std::optional<StageEffort> beforeInverse;  ///< The full stage that it began with.
  std::optional<StrutErrors> errors;
  std::optional<TargetDistance> distance;
  std::optional<SymmetryFigures> symmetry;  ///< Only of targets that are symmetric.
  std::optional<ShrinkFigures> shrink;
  std::optional<StrainFigures> strain;
  std::optional<WeightFigures> weight;  ///< Only with gravity.
  std::optional<Feasibility> feasibility;
  std::optional<PublishedFigures> published;
  bool isInterrupted = false;                ///< By Ctrl-C: not all that a run does was done.
  std::optional<std::string> deviceFailure;  ///< What the device said when it failed on the way.
  std::vector<Notice> notices;               ///< Of a finished run the most important first.
  /// Files that could not be written and why; known only after the report is.
  std::vector<std::string> lostFiles;

  /// The same in mm; with [print].
  std::optional<Eigen::Array2d> printedSheetMm() const {
    if (!printedSheet || !print) return std::nullopt;
    return Eigen::Array2d(print->scale * print->enlargement * *printedSheet);
  }
};

}  // namespace morphgrid
