#pragma once
#include <array>
#include <functional>
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

/// How a file says what it prints.
struct GcodeHeading {
  std::string command;  ///< Of morphgrid, that makes it.
  std::string what;     ///< "tier 1 of 3, from the bottom".
  std::string display;  ///< The same on the printer's display, short.
  std::string subject;  ///< "tier 1", for messages.
  std::string wayOut;   ///< What would bring it onto the bed.
};

/// G-code for what visit() lays; isPlain: without comments that name struts and hubs. Throws
/// InputError when something would be laid beside the bed.
TierGcode writeGcode(const PrintPlan& plan, const GcodeHeading& heading, bool isPlain,
                     const std::function<void(TierVisitor&)>& visit);

/// G-code for a tier, 0 the bottom one. isPlain: without comments that name struts and hubs.
/// Throws InputError when something would be laid beside the bed.
TierGcode writeTier(const PrintPlan& plan, int tier, bool isPlain);

}  // namespace morphgrid
