#pragma once
#include <array>
#include <string>
#include <vector>

#include "print/print_plan.h"
#include "print/write_tier.h"

namespace morphgrid {

/// What a specimen is for.
enum class SpecimenKind {
  chain,  ///< Its length after the bath tells what struts and hubs lose.
  curl,   ///< Passes of other heights: only for the eye, which lies flattest?
  tubes,  ///< Tubes on its hubs, whose heights tell how they grow.
};
inline constexpr std::array kSpecimenWords = {"chain", "curl", "tube"};

/// A straight chain of hubs. Lengths in mm.
struct Specimen {
  int number;  ///< From 1; printed beside its first hub.
  SpecimenKind kind;
  int struts;
  double pitch;               ///< From hub to hub as printed.
  double shareAlong;          ///< Of the free length of each strut.
  double heightStep;          ///< As PrintMaterial's.
  std::vector<double> tubes;  ///< Heights as printed, hub by hub; 0: none. Empty: none at all.
  int firstHub;               ///< Its column of the plan's positions; the others follow.
};

/// Specimens on a bed.
struct CalibrationPlate {
  /// Positions: those of all hubs, then two that hold the room for numbers. Nothing is designed.
  PrintPlan plan;
  std::vector<Specimen> specimens;
};

/// 14 chains (pitches of 12 and 24 mm; laid along, across, half and half, two of each; two with
/// passes that grow less and more than the material's) and one with tubes. Throws InputError when
/// they do not fit the bed or the material cannot be laid.
CalibrationPlate planCalibration(const Printer& printer, const PrintMaterial& material,
                                 const PrintRequest& request);

/// Throws InputError when something would be laid beside the bed.
TierGcode writeCalibration(const CalibrationPlate& plate, bool isPlain);

/// Walks the plate as it is printed.
void visitCalibration(const CalibrationPlate& plate, TierVisitor& visitor);

/// The strokes of a specimen's number.
std::vector<std::vector<Eigen::Vector2d>> numberOf(const CalibrationPlate& plate,
                                                   const Specimen& specimen);

}  // namespace morphgrid
