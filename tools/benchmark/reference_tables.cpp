#include <fmt/format.h>

#include <array>

#include "benchmark/frame_reference.h"
#include "benchmark/ladder.h"
#include "benchmark/validation_tables.h"
#include "core/bounding_diagonal.h"
#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

struct OracleCase {
  const char* name;
  double thickness;
};

constexpr std::array kOracleCases = {OracleCase{"egg_chair", 0.5}, OracleCase{"egg_chair", 0.2},
                                     OracleCase{"strip", 0.1}};

/// A solid's answer and what the frame is compared with it in: RMS distances as percent of the way
/// from flat.
class SolidComparison {
 public:
  explicit SolidComparison(FrameReference reference)
      : reference_(std::move(reference)), grid_(reference_.grid) {
    if (isLadder()) {
      grid_ = inTwoRows(grid_);
    }
  }

  const std::string& title() const { return reference_.title; }
  bool isLadder() const { return reference_.grid.shape.verticesV == 1; }
  const Eigen::Matrix3Xd& positions() const { return reference_.answers.back().positions; }
  double width() const {
    return reference_.answers.back().thickness * reference_.meanLateralRest();
  }
  double deflection() const { return alignedDistance(reference_.grid.positions, positions()); }
  double deflectionPercent() const { return 100 * deflection() / boundingDiagonal(positions()); }

  const StrutGrid& springs() const { return grid_; }
  StrutGrid frame(const JointModel& joint) const {
    return asFrame(grid_, width(), reference_.poisson, joint);
  }

  /// Of a solver's answer: the joints that the solid has.
  Eigen::Matrix3Xd joints(const Equilibrium& result) const {
    return isLadder() ? firstRow(grid_.shape, result.positions) : result.positions;
  }
  double percentOff(const Eigen::Matrix3Xd& positions) const {
    return 100 * alignedDistance(positions, this->positions()) / deflection();
  }
  /// Of the mesh before the finest one; empty where there is only one.
  std::string meshPercent() const {
    const auto& answers = reference_.answers;
    return answers.size() < 2
               ? ""
               : fmt::format("{:.2f}", percentOff(answers[answers.size() - 2].positions));
  }

 private:
  FrameReference reference_;
  StrutGrid grid_;
};

std::string oracleRow(const Device& device, const FrameReference& reference,
                      const OracleCase& one) {
  const FrameReference::Answer& answer = reference.answerAt(one.thickness);
  const StrutGrid frame = asFrame(reference.grid, one.thickness * reference.meanLateralRest(),
                                  reference.poisson, kPointJoint);
  const auto mismatch = [&](const Equilibrium& result) {
    const Mismatch direct = mismatchOf(result.positions, answer.positions);
    const Mismatch ofTwin = mismatchOf(result.positions, twinOf(frame.shape, answer.positions));
    const Mismatch& nearer = direct.rms < ofTwin.rms ? direct : ofTwin;
    return fmt::format("{:.2g} / {:.2g}", nearer.rms, nearer.largest);
  };
  const Equilibrium onDevice = MultigridSolver(device, frame).solve({});
  const Equilibrium onHost = solveFrame(frame, {});
  const Equilibrium springs = MultigridSolver(device, reference.grid).solve({});
  const Equilibrium forBars =
      MultigridSolver(device,
                      asSpringsForBars(reference.grid, one.thickness * reference.meanLateralRest()))
          .solve({});
  return fmt::format("| {} | {} | {:g} | {} | {:.0e} | {} | {:.0e} | {} | {} |\n", one.name,
                     frame.shape.vertexCount(), one.thickness, mismatch(onDevice),
                     onDevice.energy / *answer.energy - 1, mismatch(onHost),
                     onHost.energy / *answer.energy - 1, mismatch(springs), mismatch(forBars));
}

}  // namespace

std::string oracleTable(const Device& device, const std::filesystem::path& references) {
  std::string table =
      "| grid | joints | t / L | `multigrid` | its energy / oracle's - 1 | `reference` | its "
      "energy | springs | springs for bars |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const OracleCase& one : kOracleCases) {
    table +=
        oracleRow(device, loadFrameReference(references / fmt::format("{}.json", one.name)), one);
  }
  return table;
}

std::string solidLadderTable(const Device& device, const std::filesystem::path& references) {
  std::string table =
      "| solid | t | solid: a cell, in all, rad | r = t / 4, `multigrid`: a cell, in all, % off | "
      "`reference` | r = 0 with shear | springs |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (FrameReference& reference : loadSolids(references)) {
    const SolidComparison solid(std::move(reference));
    if (!solid.isLadder()) continue;
    const LadderTurns turns = turnsOf(solid.positions());
    const auto off = [&](const Equilibrium& result) {
      const LadderTurns other = turnsOf(solid.joints(result));
      return fmt::format("{:+.2f}, {:+.2f}", 100 * (other.inner / turns.inner - 1),
                         100 * (other.total / turns.total - 1));
    };
    const auto onDevice = [&](const StrutGrid& grid) {
      return off(MultigridSolver(device, grid).solve({}));
    };
    table +=
        fmt::format("| {} | {:.2g} | {:.5f}, {:.4f} | {} | {} | {} | {} |\n", solid.title(),
                    solid.width(), turns.inner, turns.total, onDevice(solid.frame(kSceneJoint)),
                    off(solveFrame(solid.frame(kSceneJoint), {})),
                    onDevice(solid.frame(kPointJoint)), onDevice(solid.springs()));
  }
  return table;
}

std::string solidTable(const Device& device, const std::filesystem::path& references) {
  std::string table =
      "| solid | t | moves by, % of the diagonal | mesh | r = t / 4, `multigrid` | `reference` | r "
      "= 0 with shear | springs | springs for bars |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (FrameReference& reference : loadSolids(references)) {
    const SolidComparison solid(std::move(reference));
    const auto onDevice = [&](const StrutGrid& grid) {
      return solid.percentOff(solid.joints(MultigridSolver(device, grid).solve({})));
    };
    table += fmt::format(
        "| {} | {:.2g} | {:.2g} | {} | **{:.2f}** | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n",
        solid.title(), solid.width(), solid.deflectionPercent(), solid.meshPercent(),
        onDevice(solid.frame(kSceneJoint)),
        solid.percentOff(solid.joints(solveFrame(solid.frame(kSceneJoint), {}))),
        onDevice(solid.frame(kPointJoint)), onDevice(solid.springs()),
        onDevice(asSpringsForBars(solid.springs(), solid.width())));
  }
  return table;
}

}  // namespace morphgrid
