#include "app/scene_knobs.h"

#include <algorithm>
#include <charconv>

#include "app/design_scene.h"

namespace morphgrid {
namespace {

constexpr double kRange = 5;  // Times and parts of what the scene has.

Knob slider(const char* key, const char* label, double value, double low, double high) {
  return {.key = key, .label = label, .value = value, .low = low, .high = high};
}

/// Of a quantity > 0.
Knob scaleSlider(const char* key, const char* label, double value) {
  Knob knob = slider(key, label, value, value / kRange, value * kRange);
  knob.isLogarithmic = true;
  return knob;
}

Knob counter(const char* key, const char* label, int value) {
  return {.key = key, .label = label, .value = double(value), .isInteger = true};
}

Knob choice(const char* key, const char* label, const char* chosen,
            std::vector<std::string> choices) {
  const auto at = std::find(choices.begin(), choices.end(), chosen) - choices.begin();
  return {.key = key, .label = label, .value = double(at), .choices = std::move(choices)};
}

/// Where a surface is designed for; grids that are given by bend angles are not.
void addDesignKnobs(std::vector<Knob>& knobs, const DesignRequest& design) {
  knobs.push_back(counter("grid.nodes_long", "nodes", design.nodesLong));
  knobs.push_back(slider("grid.curvature_cutoff", "cutoff p", design.curvatureCutoff, 0.5, 1));
  knobs.push_back(slider("grid.max_shrinkage", "max shrinkage", design.maxShrinkage, 0.05, 0.95));
  knobs.push_back(choice("design.net", "net", nameOf(design.net),
                         {nameOf(NetKind::isoline), nameOf(NetKind::orthogonal)}));
  knobs.push_back(choice("design.reference", "reference",
                         design.reference == Reference::convex ? "convex" : "middle",
                         {"convex", "middle"}));
  knobs.push_back(counter("design.compensate", "compensation rounds", design.compensateRounds));
}

}  // namespace

std::vector<Knob> knobsOf(const Scene& scene) {
  const bool isBent = std::holds_alternative<BendAngleRequest>(scene.surface);
  std::vector<Knob> knobs = {
      scaleSlider("grid.layer_spacing", "layer spacing", scene.design.layerSpacing),
      counter("grid.layers", "layers", scene.design.layers)};
  if (!isBent) {
    addDesignKnobs(knobs, scene.design);
  }
  knobs.push_back(scaleSlider("weights.lateral", "weight lateral", scene.weights.lateral));
  knobs.push_back(scaleSlider("weights.vertical", "weight vertical", scene.weights.vertical));
  knobs.push_back(slider("weights.angle", "weight angle", scene.weights.angle, 0, 10));
  knobs.push_back(
      choice("solver.method", "method", nameOf(scene.method),
             {nameOf(Method::multigrid), nameOf(Method::jacobi), nameOf(Method::reference)}));
  Knob tolerance = slider("solver.tolerance", "tolerance", scene.solve.tolerance, 1e-10, 1e-3);
  tolerance.isLogarithmic = true;
  knobs.push_back(std::move(tolerance));
  return knobs;
}

std::vector<Knob> keepRanges(std::vector<Knob> knobs, const std::vector<Knob>& before) {
  for (Knob& knob : knobs) {
    const auto old = std::find_if(before.begin(), before.end(),
                                  [&](const Knob& other) { return other.key == knob.key; });
    if (old != before.end() && old->low <= knob.value && knob.value <= old->high) {
      knob.low = old->low;
      knob.high = old->high;
    }
  }
  return knobs;
}

Knob turned(Knob knob, const std::string& text) {
  if (!knob.choices.empty()) {
    for (std::size_t n = 0; n < knob.choices.size(); ++n) {
      if (text == '"' + knob.choices[n] + '"') {
        knob.value = double(n);
      }
    }
    return knob;
  }
  double value = knob.value;
  std::from_chars(text.data(), text.data() + text.size(), value);
  knob.value = value;
  return knob;
}

}  // namespace morphgrid
