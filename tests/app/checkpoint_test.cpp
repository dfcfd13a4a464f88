#include "app/checkpoint.h"

#include <gmock/gmock.h>

#include "app/design_scene.h"
#include "core/error.h"
#include "core/read_file.h"
#include "tests/app/scene_files.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<ConvergenceSample> sampleHistory() {
  return {{1, 2.5, 0.1, 0.25, 0.125}, {2, 1.0 / 3, 1e-9, 0.5, 1}};
}

Checkpoint sampleCheckpoint() {
  Checkpoint checkpoint;
  checkpoint.settings = {{"layers", "3"}, {"nodes", "4 x 5"}};
  checkpoint.solve.phase = 2;
  checkpoint.solve.positions = Eigen::Matrix3Xd::Random(3, 7);
  checkpoint.solve.iterations = 17.0 / 3;
  checkpoint.solve.seconds = 0.1;
  checkpoint.solve.history = sampleHistory();
  return checkpoint;
}

Checkpoint sampleWithInPlane() {
  Checkpoint checkpoint = sampleCheckpoint();
  Equilibrium& inPlane = checkpoint.inPlane.emplace();
  inPlane.positions = Eigen::Matrix3Xd::Random(3, 5);
  inPlane.iterations = 12;
  inPlane.converged = true;
  inPlane.reason = StopReason::energy;
  inPlane.residual = 1.0 / 7;
  inPlane.energy = 1.0 / 9;
  inPlane.seconds = 3;
  inPlane.history = sampleHistory();
  return checkpoint;
}

void expectSame(const std::vector<ConvergenceSample>& a, const std::vector<ConvergenceSample>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t n = 0; n < a.size(); ++n) {
    EXPECT_EQ(a[n].iteration, b[n].iteration);
    EXPECT_EQ(a[n].energy, b[n].energy);
    EXPECT_EQ(a[n].residual, b[n].residual);
    EXPECT_EQ(a[n].seconds, b[n].seconds);
    EXPECT_EQ(a[n].gridShare, b[n].gridShare);
  }
}

class CheckpointFile : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "run.checkpoint"; }

  /// What reading complains of, without the folder; empty when it does not.
  std::string problem(const std::filesystem::path& file) const {
    try {
      readCheckpoint(file);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }
  std::string problemOf(const std::string& bytes) const {
    return problem(folder_.write("other.checkpoint", bytes));
  }

  TemporaryFolder folder_;
};

TEST_F(CheckpointFile, KeepsEveryBit) {
  const Checkpoint written = sampleWithInPlane();
  writeCheckpoint(file(), written);
  const Checkpoint read = readCheckpoint(file());
  EXPECT_EQ(read.settings, written.settings);
  EXPECT_EQ(read.solve.phase, written.solve.phase);
  EXPECT_EQ(read.solve.positions, written.solve.positions);
  EXPECT_EQ(read.solve.iterations, written.solve.iterations);
  EXPECT_EQ(read.solve.seconds, written.solve.seconds);
  expectSame(read.solve.history, written.solve.history);
  ASSERT_TRUE(read.inPlane);
  EXPECT_EQ(read.inPlane->positions, written.inPlane->positions);
  EXPECT_EQ(read.inPlane->iterations, 12);
  EXPECT_TRUE(read.inPlane->converged);
  EXPECT_EQ(read.inPlane->reason, StopReason::energy);
  EXPECT_EQ(read.inPlane->residual, written.inPlane->residual);
  EXPECT_EQ(read.inPlane->energy, written.inPlane->energy);
  EXPECT_EQ(read.inPlane->seconds, 3);
  expectSame(read.inPlane->history, written.inPlane->history);
}

TEST_F(CheckpointFile, HasNoInPlaneResultBeforeThereIsOne) {
  writeCheckpoint(file(), sampleCheckpoint());
  EXPECT_FALSE(readCheckpoint(file()).inPlane);
}

TEST_F(CheckpointFile, CutShortAnywhereIsRefused) {
  writeCheckpoint(file(), sampleWithInPlane());
  const std::string bytes = readFile(file());
  for (std::size_t count = 0; count < bytes.size(); count += 5) {
    ASSERT_NE(problemOf(bytes.substr(0, count)), "") << count << " bytes";
  }
  EXPECT_THAT(problemOf(bytes.substr(0, bytes.size() / 2)), HasSubstr("damaged or cut short"));
}

TEST_F(CheckpointFile, WrongBytesAreRefused) {
  writeCheckpoint(file(), sampleWithInPlane());
  const std::string bytes = readFile(file());
  for (std::size_t n = 0; n < bytes.size(); n += 5) {
    std::string damaged = bytes;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x10);
    ASSERT_NE(problemOf(damaged), "") << "byte " << n;
  }
  EXPECT_THAT(problemOf(bytes + "x"), HasSubstr("damaged"));
}

TEST_F(CheckpointFile, OtherFilesAndVersionsAreRefused) {
  EXPECT_THAT(problem(folder_ / "none"), HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(problemOf("[surface]\n"), HasSubstr("is no checkpoint of morphgrid"));
  EXPECT_THAT(problemOf(""), HasSubstr("is no checkpoint of morphgrid"));
  EXPECT_THAT(problemOf("morphgrid checkpoint 2\n{}\n"),
              HasSubstr("has format 2, this morphgrid reads format 1"));
}

TEST_F(CheckpointFile, IsOnlyWrittenWhereItMayBe) {
  EXPECT_NO_THROW(requireWritableCheckpoint(file()));
  EXPECT_EQ(folder_.fileCount(), 0);
  writeCheckpoint(file(), sampleCheckpoint());
  EXPECT_NO_THROW(requireWritableCheckpoint(file()));
  EXPECT_THROW(requireWritableCheckpoint(folder_.write("scene.toml", "a = 1")), InputError);
  EXPECT_THROW(requireWritableCheckpoint(folder_.path()), InputError);
  EXPECT_THROW(requireWritableCheckpoint(folder_ / "no" / "folder"), InputError);
}

std::map<std::string, std::string> settingsOf(const std::vector<std::string>& overrides) {
  const Scene scene = SceneFiles(kBezierScene).load(overrides);
  return checkpointSettings(scene, designScene(scene).design);
}

/// What is said when the scene has changed by these overrides since the checkpoint was written.
std::string differences(const std::vector<std::string>& overrides) {
  Checkpoint checkpoint;
  checkpoint.settings = settingsOf({});
  try {
    requireSameSettings("c", checkpoint, settingsOf(overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckpointSettings, LetTolerancesAndOutputsChange) {
  EXPECT_EQ(differences({"solver.tolerance=1e-3", "solver.energy_tolerance=0",
                         "solver.iteration_limit=7", "output.pictures=false"}),
            "");
}

TEST(CheckpointSettings, WhatDiffersIsNamed) {
  EXPECT_THAT(differences({"weights.angle=2"}),
              AllOf(HasSubstr("weights: lateral 5, vertical 40, angle 1 in the checkpoint, lateral "
                              "5, vertical 40, angle 2 in the scene"),
                    Not(HasSubstr("nodes"))));
  EXPECT_THAT(differences({"solver.method=jacobi"}),
              HasSubstr("method: multigrid in the checkpoint, jacobi in the scene"));
  EXPECT_THAT(differences({"solver.scaling=shapeop"}), HasSubstr("scaling"));
  EXPECT_THAT(differences({"grid.layers=4"}), HasSubstr("layers: 3 in the checkpoint, 4"));
  EXPECT_THAT(differences({"grid.nodes_long=9"}), HasSubstr("nodes:"));
  EXPECT_THAT(differences({"grid.layer_spacing=0.09"}), HasSubstr("layer spacing: 0.1 in"));
  // The same size, other angles.
  EXPECT_THAT(differences({"grid.curvature_cutoff=0.5"}), HasSubstr("bend angles (digest)"));
}

}  // namespace
}  // namespace morphgrid
