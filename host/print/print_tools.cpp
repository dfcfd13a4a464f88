#include "print/print_tools.h"

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "print/check_plan.h"
#include "print/place_sheet.h"
#include "print/strut_lay.h"

namespace morphgrid {
namespace {

HubShape hubOf(const PrintTools& tools) {
  return hubShapeOf(tools.request, {tools.printer.lineWidth, tools.material.tube.passHeight});
}

}  // namespace

HubShape hubShapeOf(const PrintRequest& request, const Bead& ring) {
  HubShape hub;
  hub.hole = request.pin + request.clearance;
  for (int n = 0; n < request.loops; ++n) {
    hub.ringRadii.push_back(hub.hole / 2 + ring.width / 2 + n * ring.pitch());
  }
  hub.diameter = 2 * hub.ringRadii.back() + ring.width;
  return hub;
}

PrintMaterial materialOf(const PrintTools& tools) {
  PrintMaterial material = tools.material;
  material.strut.passes = tools.request.passes.value_or(material.strut.passes);
  return material;
}

double strutWidthOf(const Printer& printer, const PrintMaterial& material) {
  const Bead bead{printer.lineWidth, material.strut.passHeight};
  return (material.strut.lines - 1) * bead.pitch() + printer.lineWidth;
}

PrintedBars printedBarsOf(const PrintTools& tools) {
  // A round bar of diameter d has I = pi d^4 / 64, a square one a^4 / 12.
  const double squareOfRound = std::pow(12 * std::numbers::pi / 64, 0.25);
  const PrintMaterial material = materialOf(tools);
  const double hub = hubOf(tools).diameter;
  return {.width = strutWidthOf(tools.printer, material),
          .height = material.strutHeightSwollen(),
          .post = squareOfRound * hub,
          .joint = hub / 2};
}

ShrinkBounds shrinkBoundsOf(const PrintTools& tools, double scale) {
  const StrutLay lay = strutLayOf(tools.material, hubOf(tools).diameter);
  return {{lay.across, lay.along}, lay.hub, lay.hubDiameter / scale};
}

double largestScale(const PrintTools& tools, const Eigen::Matrix2Xd& sheet) {
  const double hub = hubOf(tools).diameter;
  const double largest = placeSheet(sheet, hub, tools.printer).room;
  if (largest <= 0) {
    throw InputError(whyNoRoom(hub, tools.printer));
  }
  return roundedDown(largest);
}

}  // namespace morphgrid
