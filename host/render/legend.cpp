#include "render/legend.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/share_color.h"
#include "shared/strain_color.h"

namespace morphgrid {
namespace {

constexpr double kBeyond = 0.3;  // Share of the bar at either end for shares below 0 and above 1.

double shareAt(double place) { return (place - kBeyond) / (1 - 2 * kBeyond); }
double placeOf(double share) { return kBeyond + share * (1 - 2 * kBeyond); }

}  // namespace

Legend strainLegend() {
  const auto percent = std::lround(100 * kFullColorStrain);
  return {"strain",
          [](double place) {
            return strainColor(static_cast<float>((2 * place - 1) * kFullColorStrain));
          },
          // Struts beyond have the colours of the ends.
          {{0, fmt::format("≤ −{} %", percent), ""},
           {0.5, "0", ""},
           {1, fmt::format("≥ +{} %", percent), ""}}};
}

Legend shrinkLegend() {
  return {"used",
          [](double place) { return shareColor(static_cast<float>(shareAt(place))); },
          {{0.5 * placeOf(0), "grows", ""},
           {placeOf(0), "0", ""},
           {placeOf(0.5), "50", ""},
           {placeOf(1), "100 %", ""},
           {0.98, "over", ""}}};
}

Legend scaleLegend(const std::string& title, double largest, const std::string& unit) {
  return {title,
          [](double place) { return shareColor(static_cast<float>(place)); },
          {{0, "0", ""},
           {0.5, fmt::format("{:.2g}{}", largest / 2, unit), ""},
           {1, fmt::format("{:.2g}{}", largest, unit), ""}}};
}

Legend distanceLegend(double largest, double largestPercent) {
  const auto mark = [&](double share) {
    return LegendMark{share, fmt::format("{:.2g} %", share * largestPercent),
                      fmt::format("{:.2g}", share * largest)};
  };
  return {"distance",
          [](double place) { return shareColor(static_cast<float>(place)); },
          {{0, "0", "0"}, mark(0.5), mark(1)}};
}

}  // namespace morphgrid
