// Pictures and files of a run are of the grid that its state holds in the end.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/pipeline.h"
#include "app/restored_run.h"
#include "core/read_file.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

/// A run with inverse design, whose lengths are not those that it began with.
class ResultSources : public testing::Test {
 protected:
  ResultSources() {
    const ProcessResult run = runMorphgrid(
        {"run", sourceFolder() / "scenes/egg_chair_true.toml", "--quiet", "--out", path(""),
         "--set", "grid.nodes_long=8", "--set", "design.compensate=2", "--set", "design.optimise=1",
         "--set", "output.width=200", "--set", "output.height=150"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    run_ = restoreRun(path(kStateFile));
  }
  std::filesystem::path path(const std::string& name) const { return folder_ / "out" / name; }
  nlohmann::json report() const { return nlohmann::json::parse(readFile(path("report.json"))); }

  /// Draws with pictures of the run's size; the file's bytes.
  template <typename Draw>
  std::string drawn(const Draw& draw) {
    const PictureOptions picture{.width = 200, .height = 150};
    const auto file = folder_ / "drawn.png";
    Pictures pictures(
        device_, picture,
        [&](const std::string& name, const Panel& panel) {
          PictureOptions options = picture;
          options.caption = panel.caption;
          options.legend = panel.legend;
          options.scaleBar = panel.scaleBar;
          if (name == wanted_) writePng(file, composePicture(panel.scene, options));
        },
        run_.designed.view());
    draw(pictures);
    return readFile(file);
  }

  std::string wanted_;
  TemporaryFolder folder_;
  RestoredRun run_;
  Device device_{{.validation = true}};
};

TEST_F(ResultSources, PrintedLayersAreDrawnWithTheFinalLengths) {
  const StrutGrid& printed = run_.simulation.stage.grid;
  const Scene& scene = run_.scene;
  StrutGrid designed = printed;
  designed.rest = stackedGrid(run_.designed.design, scene.weights, scene.scaling,
                              run_.simulation.record.inPlane->positions)
                      .rest;
  const auto drawStacked = [&](const StrutGrid& grid) {
    wanted_ = "stacked";
    return drawn([&](Pictures& pictures) {
      pictures.drawStacked(DeviceGrid(device_, grid), grid.positions);
    });
  };
  const auto drawShrink = [&](const StrutGrid& grid) {
    wanted_ = "shrink";
    return drawn(
        [&](Pictures& pictures) { pictures.drawShrink(grid, run_.simulation.stage.shrinkBounds); });
  };
  EXPECT_EQ(drawStacked(printed), readFile(path("stacked.png")));
  EXPECT_NE(drawStacked(designed), readFile(path("stacked.png"))) << "the picture can tell";
  EXPECT_EQ(drawShrink(printed), readFile(path("shrink.png")));
  EXPECT_NE(drawShrink(designed), readFile(path("shrink.png")));
}

TEST_F(ResultSources, TheMorphedGridIsDrawnWhereItRests) {
  const Stage& stage = run_.simulation.stage;
  for (const char* name : {"warped", "surface", "distance", "target"}) {
    wanted_ = name;
    DeviceGrid grid(device_, stage.grid);
    grid.uploadPositions(stage.equilibrium.positions, stage.equilibrium.rotations);
    EXPECT_EQ(drawn([&](Pictures& pictures) {
                pictures.drawResult(grid, stage.equilibrium.positions,
                                    run_.simulation.targetFromGrid, run_.designed.targets);
              }),
              readFile(path(name + std::string(".png"))))
        << name;
  }
  EXPECT_TRUE(device_.validationMessages().empty());
}

TEST_F(ResultSources, FilesHoldTheFinalGrid) {
  const auto export_ = [&](const Simulation& simulation, const std::string& name) {
    std::filesystem::create_directories(folder_ / name);
    OutputFiles files(folder_ / name, true);
    exportFiles(simulation, run_.designed.targets, {}, files);
    EXPECT_TRUE(files.lost().empty());
  };
  export_(run_.simulation, "same");
  Simulation moved = run_.simulation;
  moved.stage.equilibrium.positions *= 1.001;
  export_(moved, "moved");
  for (const char* name :
       {"warped.glb", "warped.vtu", "printed.vtu", "surface.ply", "surface.obj"}) {
    EXPECT_EQ(readFile(folder_ / "same" / name), readFile(path(name))) << name;
    EXPECT_NE(readFile(folder_ / "moved" / name), readFile(path(name))) << name;
  }
  Simulation relengthened = run_.simulation;
  relengthened.stage.grid.rest.u[0] *= 1.001;
  export_(relengthened, "relengthened");
  for (const char* name : {"warped.vtu", "printed.vtu"}) {
    EXPECT_NE(readFile(folder_ / "relengthened" / name), readFile(path(name))) << name;
  }
}

TEST_F(ResultSources, FiguresOfTheReportAreOfTheFinalGrid) {
  const Simulation& simulation = run_.simulation;
  const auto json = report();
  EXPECT_NEAR(json["shrink"]["largest_percent"].get<double>(),
              computeShrink(simulation.stage.grid, simulation.stage.shrinkBounds).largestPercent,
              1e-9);
  const Eigen::Matrix3Xd placed =
      simulation.targetFromGrid * simulation.stage.equilibrium.positions;
  const auto target = loadTarget(run_.scene);
  const TargetDistance distance =
      computeTargetDistance(middleLayer(simulation.stage.grid.shape, placed),
                            *run_.designed.targets, &target->closestPoints());
  EXPECT_NEAR(json["distance_to_target"]["rms_percent"].get<double>(), distance.rmsPercent, 1e-9);
  // The tables' last rows are the end, too.
  const auto lastRow = [&](const char* name) {
    std::ifstream stream(path(name));
    std::string row, last;
    while (std::getline(stream, row)) last = row;
    return last;
  };
  const auto& step = json["inverse_design"]["steps"].back();
  EXPECT_THAT(lastRow("convergence.csv"), testing::StartsWith("full,"));
  EXPECT_THAT(lastRow("optimise.csv"),
              testing::HasSubstr(fmt::format("{}", step["rms_percent"].get<double>())));
}

}  // namespace
}  // namespace morphgrid
