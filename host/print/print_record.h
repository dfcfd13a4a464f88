#pragma once
#include <optional>
#include <string>
#include <vector>

#include "print/print_plan.h"
#include "print/print_tolerance.h"
#include "print/print_verdict.h"
#include "print/write_tier.h"

namespace morphgrid {

/// How the grid that is laid morphs, beside the one that was designed: distances of the middle
/// layer to the target, or where there is none to where the design ends, in percent of the
/// diagonal.
struct LaidShape {
  std::string model;  ///< What judged the distances, as material.model says it.
  bool hasTarget = false;
  double designRmsPercent = 0, designMaxPercent = 0;
  double laidRmsPercent = 0, laidMaxPercent = 0;
  bool isConverged = false;
  /// By a slow morph from flat, which is what happens in the bath.
  std::optional<double> fromFlatRmsPercent;
  bool endsThereFromFlat = true;  ///< From flat it gets to the same equilibrium.
};

/// All there is to report of a print.
struct PrintRecord {
  PrintPlan plan;
  std::vector<TierFigures> tiers;  ///< The bottom one first.
  std::optional<LaidShape> shape;  ///< None where it could not be simulated.
  std::optional<PrintTolerance> tolerance = std::nullopt;  ///< Where it was asked for.
  std::vector<std::string> notices{};
  PrintVerdict verdict{};
};

/// A short table for the terminal.
std::string printTable(const PrintRecord& record);

/// print.json.
std::string printJson(const PrintRecord& record);

/// What is not known, and whoever prints should: guesses of the material, another equilibrium.
std::vector<std::string> printNotices(const PrintRecord& record);

/// Where a strut is: "strut u 3 4 of tier 2", its tier counted from 1 at the bottom.
std::string nameOf(const GridShape& shape, const Strut& strut);

/// Of tiers, struts and tubes as they stand on each other before the bath, mm.
double stackHeight(const PrintPlan& plan);

}  // namespace morphgrid
