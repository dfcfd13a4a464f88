#include "print/calibration_plate.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "print/calibration_walk.h"
#include "print/check_plan.h"
#include "print/strut_lay.h"
#include "print/tier_tag.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;

constexpr double kShortPitch = 12;  // mm, as all lengths here.
constexpr double kLongPitch = 24;
constexpr double kChainLength = 96;
constexpr double kRowStep = 10;
/// Between passes of the chains that are to show which lies flattest.
constexpr double kCurlStep = 0.005;
/// Tubes as printed, about.
constexpr double kTubes[] = {0, 3, 6};
constexpr double kNumberSize = 2.0;   // Width of a digit.
constexpr double kNumberRoom = 10.5;  // From the first hub's middle to the far side of the number.
constexpr double kNumberGap = 1;      // From the hub to the digits, at least.

/// The six chains of one set: both pitches, laid along, across, half and half.
void addChains(std::vector<Specimen>& specimens, double heightStep) {
  for (const double pitch : {kShortPitch, kLongPitch}) {
    for (const double share : {1.0, 0.0, 0.5}) {
      specimens.push_back({.kind = SpecimenKind::chain,
                           .struts = static_cast<int>(std::lround(kChainLength / pitch)),
                           .pitch = pitch,
                           .shareAlong = share,
                           .heightStep = heightStep});
    }
  }
}

void addCurl(std::vector<Specimen>& specimens, double heightStep) {
  specimens.push_back({.kind = SpecimenKind::curl,
                       .struts = static_cast<int>(std::lround(kChainLength / kLongPitch)),
                       .pitch = kLongPitch,
                       .shareAlong = 1,
                       .heightStep = heightStep});
}

/// Two of each height, on a chain laid across, which shrinks least.
Specimen tubeSpecimen(const PrintMaterial& material) {
  Specimen specimen{.kind = SpecimenKind::tubes,
                    .struts = 5,
                    .pitch = kShortPitch,
                    .shareAlong = 0,
                    .heightStep = material.strut.heightStep};
  const double pass = material.tube.passHeight;
  for (int hub = 0; hub <= specimen.struts; ++hub) {
    specimen.tubes.push_back(std::round(kTubes[hub % std::size(kTubes)] / pass) * pass);
  }
  return specimen;
}

std::vector<Specimen> listSpecimens(const PrintMaterial& material) {
  const double step = material.strut.heightStep;
  std::vector<Specimen> specimens;
  addChains(specimens, step);
  // The second of each lies elsewhere, so that what differs over the bed averages out.
  std::vector<Specimen> again = specimens;
  specimens.insert(specimens.end(), again.rbegin(), again.rend());
  addCurl(specimens, step - kCurlStep);
  addCurl(specimens, step + kCurlStep);
  specimens.push_back(tubeSpecimen(material));
  int number = 0;
  int hub = 0;
  for (Specimen& specimen : specimens) {
    specimen.number = ++number;
    specimen.firstHub = hub;
    hub += specimen.struts + 1;
  }
  return specimens;
}

/// Rows from the front of the bed, and the corners of the room for numbers.
Eigen::Matrix2Xd placeHubs(const std::vector<Specimen>& specimens) {
  const Specimen& last = specimens.back();
  const int hubs = last.firstHub + last.struts + 1;
  Eigen::Matrix2Xd points(2, hubs + 2);
  for (const Specimen& specimen : specimens) {
    const double y = kRowStep * (specimen.number - 1);
    for (int n = 0; n <= specimen.struts; ++n) {
      points.col(specimen.firstHub + n) << n * specimen.pitch, y;
    }
  }
  points.col(hubs) << -kNumberRoom, 0;
  points.col(hubs + 1) << -kNumberRoom, kRowStep * (last.number - 1);
  return points;
}

void requireZones(const HubShape& hub) {
  const double largest = kShortPitch - 4 * kShortestZone;
  if (hub.diameter > largest) {
    throw InputError(fmt::format(
        "hubs of {:.2f} mm leave too little of a strut of {:g} mm: at most {:g} mm; a thinner pin "
        "(--pin) or fewer rings (--loops) would do",
        hub.diameter, kShortPitch, largest));
  }
}

/// Upright where it fits so, else as leaves most room.
Eigen::Matrix2Xd placeOnBed(const Eigen::Matrix2Xd& points, PrintPlan& plan) {
  const double hub = plan.hub.diameter;
  const Printer& printer = plan.printer;
  const Vector2d extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).array() + hub;
  plan.placing = placeSheet(points, hub, printer);
  if (plan.placing.room < 1) {
    throw InputError(
        fmt::format("the specimens, {:.0f} x {:.0f} mm, do not fit {:g} x {:g} mm with margins of "
                    "{:g} mm",
                    extent.x(), extent.y(), printer.bedX, printer.bedY, printer.margin));
  }
  if (extent.x() <= printer.bedX - 2 * printer.margin &&
      extent.y() <= printer.bedY - 2 * printer.margin) {
    plan.placing = {.degrees = 0, .room = plan.placing.room, .extent = extent};
  }
  return onBed(points, plan.placing.degrees, printer);
}

}  // namespace

CalibrationPlate planCalibration(const Printer& printer, const PrintMaterial& material,
                                 const PrintRequest& request) {
  CalibrationPlate plate{.plan = {.name = "calibration of " + material.name,
                                  .printer = printer,
                                  .material = material,
                                  .request = request}};
  PrintPlan& plan = plate.plan;
  plan.material.strut.passes = request.passes.value_or(material.strut.passes);
  plate.specimens = listSpecimens(plan.material);
  for (const Specimen& specimen : plate.specimens) {
    PrintMaterial laid = plan.material;
    laid.strut.heightStep = specimen.heightStep;
    requireLayable(printer, laid);
  }
  plan.hub = hubShapeOf(request, plan.strutBead(material.tube.passHeight));
  requireZones(plan.hub);
  plan.heights.strut = plan.material.strutHeight();
  plan.positions = placeOnBed(placeHubs(plate.specimens), plan);
  plan.shape = {static_cast<int>(plan.positions.cols()), 1, 1};
  return plate;
}

std::vector<std::vector<Vector2d>> numberOf(const CalibrationPlate& plate,
                                            const Specimen& specimen) {
  const Vector2d hub = plate.plan.positions.col(specimen.firstHub);
  const Vector2d along = (plate.plan.positions.col(specimen.firstHub + 1) - hub).normalized();
  const std::string digits = fmt::format("{}", specimen.number);
  const double edge = plate.plan.hub.diameter / 2;
  const double reach = kNumberRoom - edge - kNumberGap;
  auto strokes =
      numberStrokes(digits, hub - (edge + kNumberGap + reach / 2) * along, along, kNumberSize);
  // The line below the digits goes on to the hub, and begins at the other end.
  strokes[0].erase(strokes[0].begin());
  const Vector2d end = strokes[0].back();
  const Vector2d up(-along.y(), along.x());
  const double below = (end - hub).dot(up);
  strokes[0].push_back(hub - (edge + kNumberGap) * along + below * up);
  strokes[0].push_back(hub - edge * along);
  return strokes;
}

TierGcode writeCalibration(const CalibrationPlate& plate, bool isPlain) {
  const GcodeHeading heading{.command = "calibrate print",
                             .what = "specimens, see calibration.html",
                             .display = "pass",
                             .subject = "the specimens",
                             .wayOut = "a larger one"};
  return writeGcode(plate.plan, heading, isPlain,
                    [&](TierVisitor& visitor) { visitCalibration(plate, visitor); });
}

}  // namespace morphgrid
