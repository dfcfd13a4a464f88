// What a scene says about its material: what struts are, weigh, and what holds them.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/scene_keys.h"
#include "core/key_place.h"
#include "core/toml_words.h"

namespace morphgrid {
namespace {

constexpr IntegerRange kJointIndices{0, std::numeric_limits<int>::max()};
// Of densities, moduli and units in SI: no material is near the ends, and products stay numbers.
constexpr NumberRange kAmounts = fromTo(1e-15, 1e15);
constexpr const char* kSupportsAllowed =
    "of `\"middle\"`, `\"corners\"`, `\"rim\"` and arrays of 3 integers >= 0";

SceneKey sizeKey(const char* name, std::optional<double> MaterialRequest::*size,
                 const NumberRange& range, const char* defaultInWords, const char* meaning,
                 std::optional<KnobOffer> knob = std::nullopt) {
  return {.name = name,
          .value = numberKey(at(&Scene::material, size), range),
          .unit = "length",
          .defaultInWords = defaultInWords,
          .knob = std::move(knob),
          .meaning = meaning};
}

void readGravity(TomlReader& reader, Scene& scene) {
  const auto gravity = reader.section("material")
                           .vector("gravity", fromTo(-kAmounts.high, kAmounts.high),
                                   "an array of 3 numbers [x, y, z], m/s^2");
  if (gravity) {
    scene.material.gravity = {gravity->x(), gravity->y(), gravity->z()};
  }
}

std::optional<Support> supportOf(const toml::node& node) {
  if (const auto* text = node.as_string()) {
    const auto* const word = std::find(kSupportWords.begin(), kSupportWords.end(), text->get());
    return word == kSupportWords.end()
               ? std::nullopt
               : std::optional<Support>(SupportPlace(word - kSupportWords.begin()));
  }
  const toml::array* numbers = node.as_array();
  if (!numbers || numbers->size() != 3) {
    return std::nullopt;
  }
  std::array<int, 3> joint{};
  for (std::size_t n = 0; n < joint.size(); ++n) {
    const auto* number = numbers->get(n)->as_integer();
    if (!number || !kJointIndices.contains(number->get())) {
      return std::nullopt;
    }
    joint[n] = static_cast<int>(number->get());
  }
  return joint;
}

void readSupports(TomlReader& reader, Scene& scene) {
  const toml::array* supports =
      reader.section("material").array("supports", "an array of words and joints [i, j, k]");
  for (std::size_t n = 0; supports && n < supports->size(); ++n) {
    const toml::node& node = *supports->get(n);
    if (const auto support = supportOf(node)) {
      scene.material.supports.push_back(*support);
    } else {
      reader.problems.add(
          reader.place(node),
          fmt::format("material.supports[{}] must be \"middle\", \"corners\", \"rim\" or a joint "
                      "[i, j, k] of integers >= 0, got {}",
                      n, inWords(node)));
    }
  }
}

}  // namespace

SceneKeySection materialKeys() {
  using Material = MaterialRequest;
  return {"material",
          {
              {.name = "model",
               .value = wordKey(at(&Scene::material, &Material::model), kModelWords),
               .otherwise =
                   [](Scene& scene) {
                     if (scene.trueShape) scene.material.model = kTrueShape.model;
                   },
               .defaultInWords = "`\"paper\"`; `\"frame\"` for `true_shape`",
               .knob = KnobOffer{"model"},
               .meaning =
                   "`\"paper\"`: struts are springs, whose corners weigh what `weights` says. "
                   "`\"frame\"`: they are bars welded to joints at the angles at which they were "
                   "printed, as a printed grid is; needs two layers, and "
                   "`solver.method = \"multigrid\"` or `\"reference\"`. `\"bars\"`: springs that "
                   "stand for such bars, weighed by their size, whose corners rest as printed: a "
                   "preview of the frame for any method."},
              sizeKey("bar_width", &Material::barWidth, kLengths, "a fifth of the mean rest length",
                      "Width of lateral bars, in the sheet's plane.", aroundItsValue("bar width")),
              sizeKey("bar_height", &Material::barHeight, kLengths, "`bar_width`",
                      "Height of lateral bars, across the sheet.", aroundItsValue("bar height")),
              sizeKey("post_width", &Material::postWidth, kLengths, "`bar_width`",
                      "Width of the square posts between layers.", aroundItsValue("post width")),
              sizeKey("joint_radius", &Material::jointRadius, kWidths, "a quarter of `bar_width`",
                      "How much of a bar is rigid at either end."),
              {.name = "poisson",
               .value = numberKey(at(&Scene::material, &Material::poisson),
                                  NumberRange{.low = 0, .high = 0.5, .lowIncluded = true}),
               .meaning = "Poisson's ratio; it matters for twist alone."},
              {.name = "least_shrinkage",
               .value = numberKey(at(&Scene::material, &Material::leastShrinkage),
                                  NumberRange{.low = -1, .high = 1}),
               .unit = "share",
               .otherwise =
                   [](Scene& scene) {
                     if (scene.trueShape) scene.material.leastShrinkage = kTrueShape.leastShrinkage;
                   },
               .defaultInWords = "0; 0.02 for `true_shape`",
               .meaning = "Share of its printed length that a strut loses at the least; below 0 "
                          "struts may grow. Less than `grid.max_shrinkage`."},
              {.name = "supports",
               .value = CustomKey<Scene>{readSupports, "array", kSupportsAllowed},
               .meaning =
                   "Joints that are held where and as they were printed: the one in the middle of "
                   "the bottom layer, its corners, its rim, or `[i, j, k]` along u, v and up, from "
                   "0. Only for `\"frame\"`, as all that follows."},
              {.name = "slide",
               .value = booleanKey(at(&Scene::material, &Material::slide)),
               .meaning = "Whether supports keep the height of joints alone, which slide and turn, "
                          "as those of a grid that stands on smooth ground; needs three that are "
                          "not in line. Else joints that are held apart do not come closer when "
                          "the grid shrinks."},
              {.name = "gravity",
               .value = CustomKey<Scene>{readGravity, "3 numbers, m/s^2", "any"},
               .meaning = "Makes bars weigh; z is up as printed, so `[0, 0, -9.81]` on a grid that "
                          "lies. Needs `supports`, `density` and `modulus`."},
              {.name = "density",
               .value = numberKey(at(&Scene::material, &Material::density), kAmounts),
               .unit = "kg/m^3",
               .meaning = "Of the bars as printed."},
              {.name = "fluid_density",
               .value = numberKey(at(&Scene::material, &Material::fluidDensity),
                                  fromTo(0, kAmounts.high)),
               .unit = "kg/m^3",
               .meaning = "Of what is around them and carries as much of their weight; water has "
                          "1000."},
              {.name = "modulus",
               .value = numberKey(at(&Scene::material, &Material::modulus), kAmounts),
               .unit = "Pa",
               .meaning = "Young's modulus of the bars as soft as they are when the grid morphs."},
              {.name = "unit",
               .value = numberKey(at(&Scene::material, &Material::unit), kAmounts),
               .unit = "m",
               .meaning = "How long the scene's unit of length is: 0.001 where lengths are in mm. "
                          "Weight depends on it, twice the size sags twice as much for its size."},
          }};
}

}  // namespace morphgrid
