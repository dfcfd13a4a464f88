#include "print/lay_struts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace morphgrid {
namespace {

// Of enlargement, in steps of 1 / 200: 0.8 to 1.3.
constexpr int kEnlargementSteps = 200;
constexpr int kFirstEnlargement = 160;
constexpr int kLastEnlargement = 260;
/// A strut is out of range when more than this is missing, a share of its length.
constexpr double kNoExcess = 1e-6;

double excessOver(const ShrinkRange& bounds, double shrink) {
  return std::max({0.0, shrink - bounds.most, bounds.least - shrink});
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The lower, the better.
std::tuple<int, double, double> rankOf(const std::vector<DesignedStrut>& struts,
                                       const StrutLay& lay, double scale, double enlargement) {
  int count = 0;
  double squares = 0;
  std::vector<double> places;  // In the range: 0 at its least, 1 at its most.
  for (const DesignedStrut& strut : struts) {
    const ShrinkRange bounds = lay.bounds(scale * enlargement * strut.printed);
    const double shrink = strut.shrink(enlargement);
    const double excess = excessOver(bounds, shrink);
    count += excess > kNoExcess ? 1 : 0;
    squares += excess * excess;
    places.push_back((shrink - bounds.least) / (bounds.most - bounds.least));
  }
  return {count, squares, std::abs(medianOf(std::move(places)) - 0.5)};
}

void measureLengths(LayFigures& figures, std::vector<double> lengths) {
  figures.struts = static_cast<int>(lengths.size());
  figures.median = medianOf(lengths);
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  figures.shortest = *least;
  figures.longest = *most;
}

/// Counts a strut that is asked for `shrink`; returns what it is laid for.
double layStrut(PrintPlan& plan, const StrutLay& lay, const DesignedStrut& designed,
                double& freeLength, double& lengthAcross) {
  LayFigures& figures = plan.figures;
  const double length = plan.scale * plan.enlargement * designed.printed;
  const double shrink = designed.shrink(plan.enlargement);
  const ShrinkRange bounds = lay.bounds(length);
  if (excessOver(bounds, shrink) > kNoExcess) {
    figures.outOfRange.push_back({designed.strut, shrink, bounds});
    ++(shrink > bounds.most ? figures.tooMuch : figures.tooLittle);
  }
  const double asked = std::clamp(lay.shareFor(shrink, length), 0.0, 1.0);
  const double share = layableShare(asked, lay.freeLength(length));
  const double change = std::abs(lay.shrinkAt(share, length) - lay.shrinkAt(asked, length));
  if (change > 1e-9) {
    ++figures.rounded;
    figures.largestRounding = std::max(figures.largestRounding, change);
  }
  freeLength += lay.freeLength(length);
  lengthAcross += (1 - share) * lay.freeLength(length);
  return share;
}

}  // namespace

std::vector<DesignedStrut> designedStruts(const StrutGrid& grid) {
  std::vector<DesignedStrut> struts;
  struts.reserve(grid.shape.lateralStrutCount());
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    struts.push_back({strut, lengthAt(grid.positions, strut), valueAt(grid.rest, strut)});
  });
  return struts;
}

double bestEnlargement(const std::vector<DesignedStrut>& struts, const StrutLay& lay,
                       double scale) {
  if (std::get<0>(rankOf(struts, lay, scale, 1)) == 0) {
    return 1;  // As the design has it.
  }
  // A quotient, so that it is the number that its decimals say.
  const auto enlargementAt = [](int step) { return step / double{kEnlargementSteps}; };
  int best = kFirstEnlargement;
  auto bestRank = rankOf(struts, lay, scale, enlargementAt(best));
  for (int step = best + 1; step <= kLastEnlargement; ++step) {
    const auto rank = rankOf(struts, lay, scale, enlargementAt(step));
    if (rank < bestRank) {
      best = step;
      bestRank = rank;
    }
  }
  return enlargementAt(best);
}

void layStruts(const StrutGrid& grid, PrintPlan& plan) {
  const StrutLay lay = strutLayOf(plan.material, plan.hub.diameter);
  plan.shareAlong = StrutValues(grid.shape);
  plan.rest = grid.rest;
  plan.figures = {};
  std::vector<double> lengths;
  double freeLength = 0;
  double lengthAcross = 0;
  for (const DesignedStrut& strut : designedStruts(grid)) {
    const double length = plan.scale * plan.enlargement * strut.printed;
    const double share = layStrut(plan, lay, strut, freeLength, lengthAcross);
    valueAt(plan.shareAlong, strut.strut) = share;
    valueAt(plan.rest, strut.strut) = length * (1 - lay.shrinkAt(share, length)) / plan.scale;
    lengths.push_back(length);
  }
  LayFigures& figures = plan.figures;
  measureLengths(figures, std::move(lengths));
  figures.meanShareAcross = lengthAcross / freeLength;
  std::stable_sort(figures.outOfRange.begin(), figures.outOfRange.end(),
                   [](const auto& a, const auto& b) { return a.excess() > b.excess(); });
}

}  // namespace morphgrid
