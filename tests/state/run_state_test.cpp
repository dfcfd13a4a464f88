#include "state/run_state.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/read_file.h"
#include "report/report_json.h"
#include "tests/state/sample_state.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

void expectEqual(const LateralField<double>& a, const LateralField<double>& b) {
  EXPECT_EQ(a.allU(), b.allU());
  EXPECT_EQ(a.allV(), b.allV());
}

void expectEqual(const StrutValues& a, const StrutValues& b) {
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.w, b.w);
}

void expectEqual(const StrutGrid& a, const StrutGrid& b) {
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_EQ(a.spacing, b.spacing);
  EXPECT_EQ(a.positions, b.positions);
  expectEqual(a.rest, b.rest);
  expectEqual(a.stiffness, b.stiffness);
  for (const TermWeight& weight : kTermWeights) {
    EXPECT_EQ(a.weights.*weight.value, b.weights.*weight.value) << weight.name;
  }
}

void expectEqual(const GridDesign& a, const GridDesign& b) {
  EXPECT_EQ(a.nodesU, b.nodesU);
  EXPECT_EQ(a.nodesV, b.nodesV);
  EXPECT_EQ(a.layers, b.layers);
  EXPECT_EQ(a.layerSpacing, b.layerSpacing);
  EXPECT_EQ(a.spacing, b.spacing);
  expectEqual(a.lengths, b.lengths);
  expectEqual(a.bendAngles, b.bendAngles);
  ASSERT_EQ(a.rest.size(), b.rest.size());
  for (std::size_t k = 0; k < a.rest.size(); ++k) {
    expectEqual(a.rest[k], b.rest[k]);
  }
}

void expectEqual(const Equilibrium& a, const Equilibrium& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.energy, b.energy);
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t n = 0; n < a.history.size(); ++n) {
    EXPECT_EQ(a.history[n].iteration, b.history[n].iteration);
    EXPECT_EQ(a.history[n].energy, b.history[n].energy);
    EXPECT_EQ(a.history[n].residual, b.history[n].residual);
    EXPECT_EQ(a.history[n].seconds, b.history[n].seconds);
    EXPECT_EQ(a.history[n].gridShare, b.history[n].gridShare);
  }
}

class RunStateTest : public testing::Test {
 protected:
  std::filesystem::path write(const RunState& state) const {
    writeState(folder_ / kStateFile, state);
    return folder_ / kStateFile;
  }

  /// What is read is what was written.
  void expectKept(const RunState& state) const {
    const RunState read = readState(write(state));
    EXPECT_EQ(read.program, state.program);
    EXPECT_EQ(read.scene, state.scene);
    EXPECT_EQ(read.sceneFile, state.sceneFile);
    expectEqual(read.design, state.design);
    expectEqual(read.grid, state.grid);
    EXPECT_EQ(read.targets, state.targets);
    EXPECT_EQ(read.equilibrium().rotations, state.equilibrium().rotations);
    EXPECT_EQ(read.angleErrors, state.angleErrors);
    EXPECT_EQ(read.targetFromGrid.matrix(), state.targetFromGrid.matrix());
    EXPECT_EQ(toJson(read.record), toJson(state.record));
    expectEqual(*read.record.inPlane, *state.record.inPlane);
    expectEqual(read.equilibrium(), state.equilibrium());
  }

  TemporaryFolder folder_;
};

TEST_F(RunStateTest, KeepsEveryNumber) {
  const RunState state = sampleState();
  expectKept(state);
  const RunState read = readState(folder_ / kStateFile);
  ASSERT_TRUE(read.sampling);
  EXPECT_EQ(read.sampling->mesh.vertices, state.sampling->mesh.vertices);
  EXPECT_EQ(read.sampling->mesh.triangles, state.sampling->mesh.triangles);
  const RayHits& hits = read.sampling->hits;
  EXPECT_EQ(hits.points, state.sampling->hits.points);
  EXPECT_EQ(hits.hit, state.sampling->hits.hit);
  EXPECT_EQ(hits.countU, 3);
  EXPECT_EQ(hits.countV, 2);
  EXPECT_EQ(hits.box.vLength, 3);
  EXPECT_EQ(read.record.printScale, 1.125);
}

TEST_F(RunStateTest, WithoutTargetOrStackThereIsLess) {
  expectKept(plainState());
  EXPECT_FALSE(readState(folder_ / kStateFile).targets);
  EXPECT_FALSE(readState(folder_ / kStateFile).sampling);
  expectKept(flatState());
  EXPECT_FALSE(readState(folder_ / kStateFile).record.full);
}

TEST_F(RunStateTest, FlippedBytesAndTruncationsAreRefused) {
  const std::string bytes = readFile(write(sampleState()));
  const auto refused = [&](const std::string& changed) {
    try {
      readState(folder_.write("changed.safetensors", changed));
    } catch (const InputError& error) {
      return std::string(error.what()).find("; run the scene again") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refused(bytes));
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(~changed[at]);
    ASSERT_TRUE(refused(changed)) << at;
    ASSERT_TRUE(refused(bytes.substr(0, at))) << at;
  }
}

TEST_F(RunStateTest, IsFoundByItsFolderAndByItself) {
  const auto file = write(plainState());
  EXPECT_EQ(findState(folder_.path()), file);
  EXPECT_EQ(findState(file), file);
  std::filesystem::copy(file, folder_ / "renamed");
  EXPECT_EQ(findState(folder_ / "renamed"), folder_ / "renamed");
  EXPECT_EQ(findState(folder_.write("scene.toml", "title = \"a\"")), std::nullopt);
  EXPECT_EQ(findState(folder_ / "missing.toml"), std::nullopt);
  EXPECT_EQ(findState(folder_ / "missing.safetensors"), folder_ / "missing.safetensors");
  EXPECT_THROW(readState(folder_ / "missing.safetensors"), InputError);
  folder_.write("empty/file", "");
  try {
    findState(folder_ / "empty");
    FAIL() << "found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no state.safetensors in this folder"));
  }
}

}  // namespace
}  // namespace morphgrid
