#include "print/print_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "print/check_plan.h"
#include "print/lay_struts.h"

namespace morphgrid {
namespace {

constexpr int kScaleRounds = 4;  // Scale and enlargement depend on each other, but little.

/// Of all posts, scene units; 0 where there are none.
double postLength(const StrutGrid& grid) {
  double least = 0;
  double most = 0;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    if (strut.isLateral()) return;
    const double length = valueAt(grid.rest, strut);
    least = most == 0 ? length : std::min(least, length);
    most = std::max(most, length);
  });
  if (most > least * (1 + 1e-9)) {
    throw InputError(
        fmt::format("posts of {:.4g} to {:.4g} units: tubes of different heights cannot be printed",
                    least, most));
  }
  return most;
}

PrintHeights heightsOf(const PrintMaterial& material, double spacing) {
  PrintHeights heights;
  heights.strut = material.strutHeight();
  heights.strutSwollen = material.strutHeightSwollen();
  heights.spacing = spacing;
  if (spacing > 0) {
    heights.tube =
        (spacing - heights.strut * (1 + material.hub.heightChange)) / (1 + material.tube.change);
  }
  return heights;
}

/// Fills scale and enlargement.
void chooseScale(PrintPlan& plan, const StrutGrid& grid, const Eigen::Matrix2Xd& sheet) {
  const std::vector<DesignedStrut> struts = designedStruts(grid);
  const StrutLay lay = strutLayOf(plan.material, plan.hub.diameter);
  const auto enlargementFor = [&](double scale) {
    return plan.request.enlargement ? *plan.request.enlargement
                                    : bestEnlargement(struts, lay, scale);
  };
  if (plan.request.scale) {
    plan.scale = *plan.request.scale;
    plan.enlargement = enlargementFor(plan.scale);
    return;
  }
  const PrintTools tools{plan.printer, plan.material, plan.request};
  plan.scale = largestScale(tools, sheet);
  for (int round = 0; round < kScaleRounds; ++round) {
    plan.enlargement = enlargementFor(plan.scale);
    plan.scale = largestScale(tools, plan.enlargement * sheet);
  }
}

}  // namespace

PrintPlan planPrint(const std::string& name, const StrutGrid& grid, const Printer& printer,
                    const PrintMaterial& material, const PrintRequest& request) {
  PrintPlan plan{.name = name,
                 .printer = printer,
                 .material = materialOf({printer, material, request}),
                 .request = request,
                 .shape = grid.shape};
  requireLayable(printer, plan.material);
  plan.hub = hubShapeOf(request, plan.strutBead(material.tube.passHeight));
  const Eigen::Matrix2Xd sheet = grid.positions.topRows<2>();
  chooseScale(plan, grid, sheet);
  plan.heights = heightsOf(plan.material, plan.scale * postLength(grid));
  const Eigen::Matrix2Xd points = plan.scale * plan.enlargement * sheet;
  plan.placing = placeSheet(points, plan.hub.diameter, printer);
  plan.positions = onBed(points, plan.placing.degrees, printer);
  requirePrintable(plan, grid);
  layStruts(grid, plan);
  return plan;
}

}  // namespace morphgrid
