// Runs without a device: by the reference method, without pictures.
#include <gtest/gtest.h>

#include "app/pipeline.h"
#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

/// A strip that folds over itself: on the way there its energy falls while the residual does not.
constexpr const char* kFoldedPatch = R"(control_points = [
  [[9.194, 0.03652, 0], [-6.519, -0.2189, 6.322], [1.051, 0.2109, -8.351], [5.059, -0.2845, 8.181]],
  [[8.73, 1.364, 0], [-6.603, 0.761, 6.322], [0.8664, 0.6556, -8.351], [5.226, 1.318, 8.181]],
  [[9.157, 2.26, 0], [-6.947, 2.346, 6.322], [0.9565, 2.178, -8.351], [5.528, 2.09, 8.181]],
  [[9.334, 2.959, 0], [-6.928, 3.348, 6.322], [0.7682, 3.14, -8.351], [4.953, 3.027, 8.181]],
]
)";

TEST(ReferenceRun, GoesOnWhileTheEnergyFalls) {
  const SceneFiles files(
      "surface = { kind = \"bezier\", patch = \"p.toml\" }\n"
      "grid = { layers = 5, layer_spacing = 0.179913, nodes_long = 14 }\n"
      "solver = { method = \"reference\" }\noutput = { pictures = false }\n",
      kFoldedPatch);
  const TemporaryFolder folder;
  RunOptions options;
  options.outputFolder = folder / "out";
  options.quiet = true;
  const RunRecord record = runScene(files.load(), options);
  EXPECT_EQ(record.full->reason, StopReason::residual);
  EXPECT_LT(record.distance->rmsPercent, 5);  // 19.6 where it gave up.
}

}  // namespace
}  // namespace morphgrid
