#include "app/scene_knobs.h"

#include <algorithm>
#include <charconv>

#include "app/scene_keys.h"

namespace morphgrid {
namespace {

/// The knob of a key whose value the scene has.
class KnobMaker {
 public:
  KnobMaker(const Scene& scene, const KnobOffer& offer) : scene_(scene), offer_(offer) {}

  std::optional<Knob> operator()(const NumberKey<Scene>& key) const {
    auto knob = holding(key.access.get(scene_));
    if (knob) {
      const double unit = offer_.isRelative ? knob->value : 1;
      knob->low = offer_.low * unit;
      knob->high = offer_.high * unit;
      knob->isLogarithmic = offer_.isLogarithmic;
    }
    return knob;
  }

  std::optional<Knob> operator()(const IntegerKey<Scene>& key) const {
    auto knob = holding(key.access.get(scene_));
    if (knob) {
      knob->isInteger = true;
      knob->low = static_cast<double>(key.range.low);
      knob->high = static_cast<double>(key.range.high);
    }
    return knob;
  }

  std::optional<Knob> operator()(const WordKey<Scene>& key) const {
    auto knob = holding(key.access.get(scene_));
    if (knob) knob->choices = key.words;
    return knob;
  }

  std::optional<Knob> operator()(const BooleanKey<Scene>& key) const {
    auto knob = holding(key.access.get(scene_));
    if (knob) knob->isBoolean = true;
    return knob;
  }

  /// Nothing that a window can turn.
  template <typename Key>
  std::optional<Knob> operator()(const Key&) const {
    return std::nullopt;
  }

 private:
  template <typename Value>
  std::optional<Knob> holding(const std::optional<Value>& value) const {
    return value ? std::optional(Knob{.label = offer_.label, .value = static_cast<double>(*value)})
                 : std::nullopt;
  }

  const Scene& scene_;
  const KnobOffer& offer_;
};

}  // namespace

std::vector<Knob> knobsOf(const Scene& scene) {
  std::vector<Knob> knobs;
  for (const SceneKeySection& section : sceneKeys()) {
    for (const SceneKey& key : section.keys) {
      if (!key.knob || !key.isOf(scene.surface.index())) continue;
      if (auto knob = std::visit(KnobMaker(scene, *key.knob), key.value)) {
        knob->key = section.name.empty() ? key.name : section.name + "." + key.name;
        knobs.push_back(std::move(*knob));
      }
    }
  }
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
  if (knob.isBoolean) {
    knob.value = text == "true" ? 1 : 0;
    return knob;
  }
  double value = knob.value;
  std::from_chars(text.data(), text.data() + text.size(), value);
  knob.value = value;
  return knob;
}

}  // namespace morphgrid
