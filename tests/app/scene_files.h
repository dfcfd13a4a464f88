#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/scene.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {

/// Lines 1 to 5 of a good scene with a patch; what is appended goes to [grid] at first.
inline constexpr const char* kBezierScene = R"([surface]
kind = "bezier"
patch = "p.toml"
[grid]
layer_spacing = 0.1
)";

/// Lines 1 to 6 of a good scene with bend angles; what is appended goes to [grid] at first.
inline constexpr const char* kBendAnglesScene = R"([surface]
kind = "bend_angles"
[grid]
layer_spacing = 0.1
nodes_u = 4
nodes_v = 3
)";

inline constexpr const char* kGoodPatch = R"(control_points = [
  [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0]],
  [[0, 1, 0], [1, 1, 1], [2, 1, 1], [3, 1, 0]],
  [[0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, 0]],
  [[0, 3, 0], [1, 3, 1], [2, 3, 1], [3, 3, 0.5]],
]
)";

/// A folder with scene.toml and the patch p.toml that it may refer to.
class SceneFiles {
 public:
  explicit SceneFiles(const std::string& scene, const std::string& patch = kGoodPatch)
      : scene_(folder_.write("scene.toml", scene)) {
    folder_.write("p.toml", patch);
  }

  Scene load(const std::vector<std::string>& overrides = {}) const {
    return loadScene(scene_, overrides);
  }

  /// What loading complains of, without the folder; empty when it does not.
  std::string problems(const std::vector<std::string>& overrides = {}) const {
    try {
      load(overrides);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path scene_;
};

/// Text appended to a good scene, and the whole message that it brings about.
struct BadCase {
  const char* appended;
  const char* message;
};

/// Each case on its own.
inline void expectMessages(const std::string& scene, const std::vector<BadCase>& cases) {
  for (const BadCase& bad : cases) {
    SCOPED_TRACE(bad.appended);
    EXPECT_EQ(SceneFiles(scene + bad.appended).problems(), bad.message);
  }
}

}  // namespace morphgrid
