#include <fmt/format.h>

#include <cmath>
#include <set>

#include "print/assembly_page.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;

constexpr double kFrame = 12;  // Around the tier, for the line and the words, mm.
constexpr double kRuler = 50;

/// Millimetres from the map's upper left, for points on the bed.
struct MapFrame {
  Vector2d low, size;

  Vector2d at(const Vector2d& point) const {
    return {point.x() - low.x(), size.y() - (point.y() - low.y())};
  }
};

MapFrame mapFrameOf(const PrintPlan& plan) {
  const double around = plan.hub.diameter / 2 + kFrame;
  const Vector2d low = plan.positions.rowwise().minCoeff().array() - around;
  const Vector2d high = plan.positions.rowwise().maxCoeff().array() + around;
  return {low, high - low};
}

std::string mapStruts(const PrintPlan& plan, int tier, const MapFrame& frame) {
  std::set<std::pair<int, Strut::Direction>> outside;
  for (const StrutOutOfRange& strut : plan.figures.outOfRange) {
    outside.insert({strut.strut.from, strut.strut.direction});
  }
  std::string text = fmt::format("<g stroke-width=\"{:.2f}\">\n", plan.strutWidth());
  forEachLateralStrut(plan.shape, [&](const Strut& strut) {
    if (strut.layer != tier) return;
    const Vector2d from = plan.positions.col(strut.from);
    const Vector2d to = plan.positions.col(strut.to);
    const Vector2d hub = plan.hub.diameter / 2 * (to - from).normalized();
    const Vector2d a = frame.at(from + hub);
    const Vector2d b = frame.at(to - hub);
    text += fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\"{}/>\n", a.x(),
        a.y(), b.x(), b.y(), shareColour(valueAt(plan.shareAlong, strut)),
        outside.count({strut.from, strut.direction}) ? " stroke-dasharray=\"1 0.6\"" : "");
  });
  return text + "</g>\n";
}

std::string mapHubs(const PrintPlan& plan, int tier, const MapFrame& frame) {
  const double radius = (plan.hub.diameter + plan.hub.hole) / 4;
  std::string text = fmt::format("<g fill=\"none\" stroke=\"#888\" stroke-width=\"{:.2f}\">\n",
                                 (plan.hub.diameter - plan.hub.hole) / 2);
  for (int column = 0; column < plan.shape.layerVertexCount(); ++column) {
    const Vector2d hub = frame.at(plan.positions.col(plan.shape.index(column, tier)));
    text += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", hub.x(), hub.y(),
                        radius);
  }
  return text + "</g>\n";
}

std::string mapWords(const PrintPlan& plan, int tier, const MapFrame& frame) {
  const Vector2d corner = frame.at(plan.at({0, 0, tier}));
  const double bottom = frame.size.y() - 3;
  return fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\" stroke=\"#000\" "
      "stroke-width=\"0.5\"/>\n<g font-family=\"sans-serif\" font-size=\"4\">\n"
      "<text x=\"3\" y=\"6\">tier {} of {}, from the bottom; the ring marks its corner 0, "
      "0</text>\n"
      "<line x1=\"3\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"#000\" "
      "stroke-width=\"0.4\"/>\n<text x=\"{:.2f}\" y=\"{:.2f}\">{:g} mm</text>\n</g>\n",
      corner.x(), corner.y(), plan.hub.diameter / 2 + 1.5, tier + 1, plan.shape.layers, bottom,
      3 + kRuler, bottom, 5 + kRuler, bottom + 1, kRuler);
}

}  // namespace

std::string shareColour(double share) {
  constexpr double kAcross[] = {47, 108, 190};
  constexpr double kAlong[] = {214, 60, 40};
  const auto part = [&](int n) {
    return std::lround(kAcross[n] + share * (kAlong[n] - kAcross[n]));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

std::string tierMap(const PrintPlan& plan, int tier) {
  const MapFrame frame = mapFrameOf(plan);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.2f}mm\" height=\"{1:.2f}mm\" "
             "viewBox=\"0 0 {0:.2f} {1:.2f}\">\n",
             frame.size.x(), frame.size.y()) +
         mapStruts(plan, tier, frame) + mapHubs(plan, tier, frame) + mapWords(plan, tier, frame) +
         "</svg>\n";
}

}  // namespace morphgrid
