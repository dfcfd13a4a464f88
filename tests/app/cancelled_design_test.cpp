// Designs that nobody waits for any more.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "app/design_scene.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

struct DesignCase {
  std::string scene;
  std::vector<std::string> overrides;
  int lines;  ///< Lines of the net in both directions: the design is to look at least once a line
              ///< whether to go on.
};

class CancelledDesign : public testing::TestWithParam<DesignCase> {
 protected:
  /// Cancels from the nth time on that a thread asks; returns whether that ended the design.
  bool cancelAt(int n) {
    asked_ = 0;
    Scene scene =
        loadScene(sourceFolder() / "scenes" / (GetParam().scene + ".toml"), GetParam().overrides);
    scene.solve.isCancelled = [this, n] { return ++asked_ >= n && n > 0; };
    try {
      designScene(scene);
      return false;
    } catch (const Cancelled&) {
      return true;
    }
  }

  std::atomic<int> asked_ = 0;
};

TEST_P(CancelledDesign, EndsWhereverItIs) {
  ASSERT_FALSE(cancelAt(0));
  const int all = asked_;
  const auto threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  EXPECT_GE(all, GetParam().lines);
  for (const int n : {1, all / 2, all}) {
    EXPECT_TRUE(cancelAt(n)) << n << " of " << all;
    EXPECT_LT(asked_, n + threads) << "it goes on";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Surfaces, CancelledDesign,
    testing::Values(DesignCase{"patch", {"grid.nodes_long=30"}, 50},
                    DesignCase{"patch", {"grid.nodes_long=30", "design.net=orthogonal"}, 50},
                    DesignCase{"face", {"grid.nodes_long=30"}, 50},
                    DesignCase{"face", {"grid.nodes_long=30", "design.net=orthogonal"}, 50}));

}  // namespace
}  // namespace morphgrid
