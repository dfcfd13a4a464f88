// What holds for every key of a scene, whichever they are.
#include "app/scene_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/app/scene_files.h"
#include "tests/support/height_field.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

/// Good scenes of all kinds in one folder, as overrides have it.
class ScenesOfAllKinds : public testing::Test {
 protected:
  ScenesOfAllKinds() {
    folder_.write("p.toml", kGoodPatch);
    folder_.write("m.obj", heightFieldObj(dome));
    folder_.write("m.toml", "mesh = \"m.obj\"\n");
    scenes_ = {folder_.write("bezier.toml", kBezierScene),
               folder_.write("mesh.toml",
                             "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\nu_start = -1\n"
                             "v_start = -1\nu_length = 2\nv_length = 2\n[grid]\n"
                             "layer_spacing = 0.1\n"),
               folder_.write("bend_angles.toml", kBendAnglesScene)};
  }

  Scene load(std::size_t kind, const std::vector<std::string>& overrides = {}) const {
    return loadScene(scenes_[kind], overrides);
  }
  std::string problems(std::size_t kind, const std::vector<std::string>& overrides) const {
    try {
      load(kind, overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  using Visit = std::function<void(const SceneKey&, const std::string& dotted, std::size_t kind)>;

  /// Every key with every kind of surface that has it.
  static void forEachKey(const Visit& visit) {
    for (const SceneKeySection& section : sceneKeys()) {
      for (const SceneKey& key : section.keys) {
        for (std::size_t kind = 0; kind < kSurfaceWords.size(); ++kind) {
          const std::string dotted =
              section.name.empty() ? key.name : section.name + "." + key.name;
          SCOPED_TRACE(fmt::format("{} of {}", dotted, kSurfaceWords[kind]));
          if (key.isOf(kind)) visit(key, dotted, kind);
        }
      }
    }
  }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> scenes_;
};

TEST_F(ScenesOfAllKinds, AreOfTheKindsThatTheKeysKnow) {
  ASSERT_EQ(std::variant_size_v<SurfaceRequest>, kSurfaceWords.size());
  for (std::size_t kind = 0; kind < kSurfaceWords.size(); ++kind) {
    EXPECT_EQ(load(kind).surface.index(), kind);
    EXPECT_EQ(sceneKinds().beginsWith(kind).surface.index(), kind);
  }
}

TEST_F(ScenesOfAllKinds, HaveTheDefaultsOfTheDocumentation) {
  const KeyDocument<Scene> document(sceneKinds());
  int compared = 0;
  forEachKey([&](const SceneKey& key, const std::string& dotted, std::size_t kind) {
    const auto value = document.defaultOf(key);
    if (!value || key.isRequired || !key.defaultInWords.empty()) return;
    const Scene left = load(kind);
    const Scene given = load(kind, {dotted + "=" + *value});
    std::visit(
        [&](const auto& typed) {
          if constexpr (requires { typed.access; }) {
            ASSERT_TRUE(typed.access.get(left));
            EXPECT_EQ(typed.access.get(left), typed.access.get(given));
            ++compared;
          }
        },
        key.value);
  });
  EXPECT_GT(compared, 50);
}

/// Numbers just beyond a range, as TOML.
std::vector<std::string> beyond(const NumberRange& range) {
  std::vector<std::string> numbers = {"nan", "inf", "-inf", "\"1\"", "true"};
  const auto little = [](double bound) { return 1e-9 * std::max(1.0, std::abs(bound)); };
  if (std::isfinite(range.low)) {
    numbers.push_back(fmt::format("{}", range.low - (range.lowIncluded ? little(range.low) : 0)));
  }
  if (std::isfinite(range.high)) {
    numbers.push_back(
        fmt::format("{}", range.high + (range.highIncluded ? little(range.high) : 0)));
  }
  return numbers;
}

std::vector<std::string> beyond(const IntegerRange& range) {
  std::vector<std::string> numbers = {"1.5", "\"1\"", "nan"};
  const IntegerRange all;
  if (range.low != all.low) numbers.push_back(fmt::format("{}", range.low - 1));
  if (range.high != all.high) numbers.push_back(fmt::format("{}", range.high + 1));
  return numbers;
}

TEST_F(ScenesOfAllKinds, RefuseWhatIsBeyondTheRangeOfAKey) {
  forEachKey([&](const SceneKey& key, const std::string& dotted, std::size_t kind) {
    const auto refuse = [&](const std::vector<std::string>& values, const std::string& allowed) {
      for (const std::string& value : values) {
        EXPECT_THAT(problems(kind, {dotted + "=" + value}),
                    HasSubstr(dotted + " must be " + allowed + ", got "));
      }
    };
    if (const auto* number = std::get_if<NumberKey<Scene>>(&key.value)) {
      refuse(beyond(number->range), describe(number->range));
    }
    if (const auto* integer = std::get_if<IntegerKey<Scene>>(&key.value)) {
      refuse(beyond(integer->range), describe(integer->range));
    }
    if (std::get_if<BooleanKey<Scene>>(&key.value)) {
      refuse({"1", "\"yes\""}, "true or false");
    }
    if (const auto* word = std::get_if<WordKey<Scene>>(&key.value)) {
      refuse({"\"\"", "0"}, fmt::format("\"{}\"", fmt::join(word->words, "\" or \"")));
    }
  });
}

TEST_F(ScenesOfAllKinds, RefuseTheKeysOfOthers) {
  for (const SceneKeySection& section : sceneKeys()) {
    for (const SceneKey& key : section.keys) {
      for (std::size_t kind = 0; kind < kSurfaceWords.size(); ++kind) {
        if (key.isOf(kind)) continue;
        const std::string dotted = section.name.empty() ? key.name : section.name + "." + key.name;
        EXPECT_THAT(problems(kind, {dotted + "=1"}),
                    HasSubstr(dotted + " belongs to surfaces of kind \""));
      }
    }
  }
}

TEST_F(ScenesOfAllKinds, MissWhatAKeyRequires) {
  forEachKey([&](const SceneKey& key, const std::string& dotted, std::size_t kind) {
    if (!key.isRequired) return;
    const auto empty = folder_.write(
        "empty.toml", fmt::format("surface = {{kind = \"{}\"}}\n", kSurfaceWords[kind]));
    if (dotted == "surface.kind") folder_.write("empty.toml", "");
    try {
      loadScene(empty);
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(dotted + " is missing: it must be "));
    }
  });
}

TEST(SceneKeys, HaveNamesAndMeaningsOfTheirOwn) {
  std::set<std::string> names;
  for (const SceneKeySection& section : sceneKeys()) {
    for (const SceneKey& key : section.keys) {
      EXPECT_TRUE(names.insert(section.name + "." + key.name).second) << key.name;
      EXPECT_EQ(key.meaning.back(), '.') << key.name;
      EXPECT_EQ(key.meaning.find('|'), std::string::npos) << "it ends the cell of a table";
    }
  }
}

}  // namespace
}  // namespace morphgrid
