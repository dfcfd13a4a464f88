#include "app/checkpoint.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/design_scene.h"
#include "core/array_file.h"
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

Equilibrium sampleEquilibrium(int vertices) {
  Equilibrium equilibrium;
  equilibrium.positions = Eigen::Matrix3Xd::Random(3, vertices);
  equilibrium.iterations = 12;
  equilibrium.converged = true;
  equilibrium.reason = StopReason::energy;
  equilibrium.residual = 1.0 / 7;
  equilibrium.energy = 1.0 / 9;
  equilibrium.seconds = 3;
  equilibrium.history = sampleHistory();
  return equilibrium;
}

Checkpoint sampleCheckpoint() {
  Checkpoint checkpoint;
  checkpoint.problem = {"0123", {{"layers", "3"}, {"nodes", "4 x 5"}}};
  checkpoint.solve = SolveCheckpoint{2,
                                     Eigen::Matrix3Xd::Random(3, 7),
                                     JointRotations::Random(4, 7),
                                     17.0 / 3,
                                     0.1,
                                     sampleHistory()};
  return checkpoint;
}

Checkpoint sampleInInverseDesign() {
  Checkpoint checkpoint = sampleCheckpoint();
  checkpoint.solve.reset();
  checkpoint.inPlane = sampleEquilibrium(5);
  checkpoint.full = sampleEquilibrium(7);
  InverseCheckpoint& inverse = checkpoint.inverse.emplace();
  inverse.compensated = true;
  inverse.present = {Eigen::VectorXd::Random(8), sampleEquilibrium(7)};
  inverse.present.equilibrium.rotations = JointRotations::Random(4, 7);
  inverse.kept = {Eigen::VectorXd::Random(8), sampleEquilibrium(7)};
  inverse.keptSteps = 1;
  inverse.returns = 2;
  inverse.steps = {{InverseStep::Kind::design, 0, 3.5, 7.25, 40, 1.5, 3, 12, 0, 0.5},
                   {InverseStep::Kind::optimise, 1, 1.0 / 3, 0.5, 39, 2.5, 0, 7, 6, 0.75}};
  inverse.objectives = {0.25};
  inverse.aim = Eigen::Matrix3Xd::Random(3, 9);
  inverse.pairs = {{Eigen::VectorXd::Random(8), Eigen::VectorXd::Random(8)}};
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

void expectSame(const Equilibrium& a, const Equilibrium& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.rotations, b.rotations);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.converged, b.converged);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_EQ(a.seconds, b.seconds);
  expectSame(a.history, b.history);
}

void expectSame(const InverseStep& a, const InverseStep& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.rmsPercent, b.rmsPercent);
  EXPECT_EQ(a.maxPercent, b.maxPercent);
  EXPECT_EQ(a.largestShrinkPercent, b.largestShrinkPercent);
  EXPECT_EQ(a.largestStrainPercent, b.largestStrainPercent);
  EXPECT_EQ(a.strutsAtBound, b.strutsAtBound);
  EXPECT_EQ(a.cycles, b.cycles);
  EXPECT_EQ(a.adjointProducts, b.adjointProducts);
  EXPECT_EQ(a.seconds, b.seconds);
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

TEST_F(CheckpointFile, KeepsEveryBitOfASolve) {
  const Checkpoint written = sampleCheckpoint();
  writeCheckpoint(file(), written);
  const Checkpoint read = readCheckpoint(file());
  EXPECT_EQ(read.problem, written.problem);
  EXPECT_FALSE(read.inPlane || read.full || read.inverse);
  ASSERT_TRUE(read.solve);
  EXPECT_EQ(read.solve->phase, written.solve->phase);
  EXPECT_EQ(read.solve->positions, written.solve->positions);
  EXPECT_EQ(read.solve->rotations, written.solve->rotations);
  EXPECT_EQ(read.solve->iterations, written.solve->iterations);
  EXPECT_EQ(read.solve->seconds, written.solve->seconds);
  expectSame(read.solve->history, written.solve->history);
}

TEST_F(CheckpointFile, KeepsEveryBitOfInverseDesign) {
  const Checkpoint written = sampleInInverseDesign();
  writeCheckpoint(file(), written);
  const Checkpoint read = readCheckpoint(file());
  EXPECT_FALSE(read.solve);
  ASSERT_TRUE(read.inPlane && read.full && read.inverse);
  expectSame(*read.inPlane, *written.inPlane);
  expectSame(*read.full, *written.full);
  const InverseCheckpoint& a = *read.inverse;
  const InverseCheckpoint& b = *written.inverse;
  EXPECT_EQ(a.compensated, b.compensated);
  EXPECT_EQ(a.present.rest, b.present.rest);
  expectSame(a.present.equilibrium, b.present.equilibrium);
  EXPECT_EQ(a.kept.rest, b.kept.rest);
  expectSame(a.kept.equilibrium, b.kept.equilibrium);
  EXPECT_EQ(a.keptSteps, b.keptSteps);
  EXPECT_EQ(a.returns, b.returns);
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (std::size_t n = 0; n < a.steps.size(); ++n) {
    expectSame(a.steps[n], b.steps[n]);
  }
  EXPECT_EQ(a.objectives, b.objectives);
  EXPECT_EQ(a.aim, b.aim);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  EXPECT_EQ(a.pairs.front().step, b.pairs.front().step);
  EXPECT_EQ(a.pairs.front().change, b.pairs.front().change);
}

TEST_F(CheckpointFile, CutShortAnywhereIsRefused) {
  writeCheckpoint(file(), sampleInInverseDesign());
  const std::string bytes = readFile(file());
  for (std::size_t count = 0; count < bytes.size(); count += 5) {
    ASSERT_NE(problemOf(bytes.substr(0, count)), "") << count << " bytes";
  }
  EXPECT_THAT(problemOf(bytes.substr(0, bytes.size() / 2)), HasSubstr("damaged or cut short"));
}

TEST_F(CheckpointFile, WrongBytesAreRefused) {
  writeCheckpoint(file(), sampleInInverseDesign());
  const std::string bytes = readFile(file());
  for (std::size_t n = 0; n < bytes.size(); n += 5) {
    std::string damaged = bytes;
    damaged[n] = static_cast<char>(damaged[n] ^ 0x10);
    ASSERT_NE(problemOf(damaged), "") << "byte " << n;
  }
  EXPECT_THAT(problemOf(bytes + "x"), HasSubstr("damaged"));
}

// The checksum holds, but no run can have written it.
TEST_F(CheckpointFile, ContentsThatMakeNoSenseAreRefused) {
  const auto problemWith = [&](const auto& change) {
    Checkpoint checkpoint = sampleInInverseDesign();
    checkpoint.solve = sampleCheckpoint().solve;
    change(checkpoint);
    writeCheckpoint(file(), checkpoint);
    return problem(file());
  };
  const auto damaged = HasSubstr("the checkpoint is damaged or cut short");
  EXPECT_EQ(problemWith([](Checkpoint&) {}), "");
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.solve->phase = -1; }), damaged);
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.solve->positions(1, 2) = std::nan(""); }), damaged);
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.full->reason = static_cast<StopReason>(7); }),
              damaged);
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.inPlane->history[1].iteration = -1; }), damaged);
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.inverse->steps[1].number = -1; }), damaged);
  EXPECT_THAT(problemWith([](Checkpoint& c) { c.inverse->pairs[0].step[3] = std::nan(""); }),
              damaged);
}

TEST_F(CheckpointFile, OtherFilesAndVersionsAreRefused) {
  EXPECT_THAT(problem(folder_ / "none"), HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(problemOf("[surface]\n"), HasSubstr("is no checkpoint of morphgrid"));
  EXPECT_THAT(problemOf(""), HasSubstr("is no checkpoint of morphgrid"));
  writeArrayFile(file(), {"morphgrid checkpoint", 1, "", ""}, {}, {});
  EXPECT_THAT(problem(file()), HasSubstr("has version 1, this morphgrid reads version 5"));
  writeArrayFile(file(), {"morphgrid state", 3, "", ""}, {}, {});
  EXPECT_THAT(problem(file()), HasSubstr("is no checkpoint of morphgrid"));
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

ProblemIdentity identityOf(const std::vector<std::string>& overrides) {
  const Scene scene = SceneFiles(kBezierScene).load(overrides);
  return identifyProblem(scene, designScene(scene));
}

/// What is said when the scene has changed by these overrides since the checkpoint was written.
std::string differences(const std::vector<std::string>& overrides) {
  try {
    requireSameProblem("c", {identityOf({})}, identityOf(overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CheckpointProblem, LetsTolerancesLimitsAndOutputsChange) {
  EXPECT_EQ(differences({"solver.tolerance=1e-3", "solver.energy_tolerance=0",
                         "solver.iteration_limit=7", "output.pictures=false", "design.optimise=3"}),
            "");
}

TEST(CheckpointProblem, WhatDiffersIsNamed) {
  EXPECT_THAT(differences({"weights.angle=2"}),
              AllOf(HasSubstr("weights: lateral 5, vertical 40, angle 1 in the checkpoint, lateral "
                              "5, vertical 40, angle 2 in the scene"),
                    HasSubstr("give those that it was written with, or start anew"),
                    Not(HasSubstr("nodes"))));
  EXPECT_THAT(differences({"solver.method=jacobi"}),
              HasSubstr("method: multigrid in the checkpoint, jacobi in the scene"));
  EXPECT_THAT(differences({"solver.scaling=shapeop"}), HasSubstr("scaling"));
  EXPECT_THAT(differences({"grid.layers=4"}), HasSubstr("layers: 3 in the checkpoint, 4"));
  EXPECT_THAT(differences({"grid.nodes_long=9"}), HasSubstr("nodes:"));
  EXPECT_THAT(differences({"grid.layer_spacing=0.09"}), HasSubstr("layer spacing: 0.1 in"));
  // The same size, other angles.
  EXPECT_THAT(differences({"grid.curvature_cutoff=0.5"}), HasSubstr("curvature cutoff: 1 in"));
  EXPECT_THAT(differences({"design.enforce_shrinkage=true"}),
              HasSubstr("enforced shrinkage: none in the checkpoint, 0 to 0.4"));
}

TEST(CheckpointProblem, KnowsTheSheetAndItsBounds) {
  EXPECT_THAT(differences({"design.layout=conformal"}),
              HasSubstr("layout: in_plane in the checkpoint, conformal in the scene"));
  EXPECT_THAT(differences({"design.max_strain=0.1"}),
              HasSubstr("largest strain: none in the checkpoint, 0.1 in the scene"));
}

TEST(CheckpointProblem, KnowsWeightAndSupports) {
  const std::vector<std::string> held{"grid.layers=2", "material.model=frame",
                                      "material.supports=[\"middle\"]"};
  const auto heavy = [&](const char* density) {
    std::vector<std::string> overrides = held;
    overrides.insert(overrides.end(), {"material.gravity=[0, 0, -9.81]", "material.modulus=1e6",
                                       std::string("material.density=") + density});
    return overrides;
  };
  const auto differences = [](const std::vector<std::string>& before,
                              const std::vector<std::string>& after) {
    try {
      requireSameProblem("c", {identityOf(before)}, identityOf(after));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(differences(heavy("1200"), heavy("1200")), "");
  EXPECT_THAT(differences(held, heavy("1200")),
              HasSubstr("weight: none in the checkpoint, gravity [0, 0, -9.81], density 1200 in 0, "
                        "modulus 1000000, unit 0.001 m in the scene"));
  EXPECT_THAT(differences(heavy("1300"), heavy("1200")), HasSubstr("weight: gravity"));
  EXPECT_THAT(differences({held[0], held[1]}, held),
              HasSubstr("supports: none in the checkpoint, middle in the scene"));
}

TEST(CheckpointProblem, IsEveryNumberOfTheGrid) {
  const Scene scene = SceneFiles(kBezierScene).load();
  const SceneDesign designed = designScene(scene);
  const ProblemIdentity written = identifyProblem(scene, designed);
  const auto isTold = [&](const auto& change) {
    SceneDesign other = designed;
    change(other);
    const ProblemIdentity now = identifyProblem(scene, other);
    EXPECT_EQ(now.settings, written.settings);
    try {
      requireSameProblem("c", {written}, now);
    } catch (const InputError& error) {
      return std::string(error.what()).find("the lengths designed from it") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(isTold([](SceneDesign&) {}));
  EXPECT_TRUE(isTold([](SceneDesign& d) { d.design.rest[1].u(0, 0) *= 1 + 1e-15; }));
  EXPECT_TRUE(isTold([](SceneDesign& d) { d.design.lengths.v(1, 0) *= 1 + 1e-15; }));
  EXPECT_TRUE(isTold([](SceneDesign& d) { (*d.targets)(2, 3) += 1e-9; }));
}

}  // namespace
}  // namespace morphgrid
