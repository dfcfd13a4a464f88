#pragma once
#include <array>
#include <string>

#include "print/print_path.h"
#include "print/print_plan.h"

namespace morphgrid {

/// What printing a tier takes.
struct TierFigures {
  int passes = 0;                           ///< Heights at which something is laid.
  std::array<double, kPathKinds> pathMm{};  ///< Of each PathKind.
  double travelMm = 0;
  int retractions = 0;
  double volume = 0;      ///< mm^3, with what fills the nozzle.
  double filamentMm = 0;  ///< The same as a length.
  double grams = 0;
  double seconds = 0;

  double laidMm() const;
};

/// A tier's file.
struct TierGcode {
  std::string text;
  TierFigures figures;
};

/// G-code for a tier, 0 the bottom one. isPlain: without comments that name struts and hubs.
/// Throws InputError when something would be laid beside the bed.
TierGcode writeTier(const PrintPlan& plan, int tier, bool isPlain);

}  // namespace morphgrid
