#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>

#include "benchmark/bar_network.h"
#include "benchmark/frame_reference.h"
#include "benchmark/validation_tables.h"
#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

struct SubdividedCase {
  const char* name;
  double thickness;
};

constexpr std::array kSubdividedCases = {SubdividedCase{"strip", 0.1},
                                         SubdividedCase{"egg_chair", 0.2},
                                         SubdividedCase{"egg_chair", 0.5}};

constexpr const char* kInvarianceFile = "solid_saddle_5_30_t0.2.json";
constexpr double kTurn = 0.7;  // Radians, about z.
const Eigen::Vector3d kShift(30, -20, 10);
constexpr double kUnit = 25.4;

void transform(StrutGrid& grid, const Eigen::Isometry3d& motion) {
  grid.positions = motion * grid.positions;
}

/// Along u, the last comes first.
StrutGrid mirrored(const StrutGrid& grid) {
  StrutGrid result = grid;
  result.positions = twinOf(grid.shape, grid.positions);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const auto image = [&](int vertex) {
      const GridPlace place = grid.shape.place(vertex);
      return grid.shape.index(grid.shape.verticesU - 1 - place.i, place.j, place.layer);
    };
    const int from = std::min(image(strut.from), image(strut.to));
    const Strut original{from, std::max(image(strut.from), image(strut.to)), strut.direction,
                         strut.layer};
    valueAt(result.rest, strut) = valueAt(grid.rest, original);
  });
  return result;
}

StrutGrid inUnit(const StrutGrid& grid, double unit) {
  StrutGrid result = grid;
  result.spacing *= unit;
  result.positions *= unit;
  for (auto* values : {&result.rest.u, &result.rest.v, &result.rest.w}) {
    for (double& length : *values) {
      length *= unit;
    }
  }
  return result;
}

}  // namespace

std::string subdivisionTable(const std::filesystem::path& references) {
  std::string table =
      "| grid | t / L | joints, of halved bars | RMS / largest, % of the diagonal |\n"
      "| --- | --- | --- | --- |\n";
  for (const SubdividedCase& one : kSubdividedCases) {
    const FrameReference reference =
        loadFrameReference(references / fmt::format("{}.json", one.name));
    const StrutGrid frame = asFrame(reference.grid, one.thickness * reference.meanLateralRest(),
                                    reference.poisson, kPointJoint);
    const Equilibrium whole = solveFrame(frame, {});
    const NetworkState halves =
        solveNetwork(halvedBars(frame), halvedState(frame, {whole.positions, whole.rotations}));
    const Mismatch mismatch =
        mismatchOf(whole.positions, halves.positions.leftCols(whole.positions.cols()));
    table += fmt::format("| {} | {:g} | {} | {:.4f} / {:.4f} |\n", one.name, one.thickness,
                         halves.positions.cols(), mismatch.rms, mismatch.largest);
  }
  return table;
}

std::string invarianceTable(const Device& device, const std::filesystem::path& references) {
  const FrameReference reference = loadFrameReference(references / kInvarianceFile);
  const double width = reference.answers.back().thickness * reference.meanLateralRest();
  const auto framed = [&](const StrutGrid& grid, double unit) {
    return asFrame(grid, unit * width, reference.poisson, kSceneJoint);
  };
  const StrutGrid& flat = reference.grid;
  const StrutGrid original = framed(flat, 1);
  const Eigen::Matrix3Xd onDevice = MultigridSolver(device, original).solve({}).positions;
  const Eigen::Matrix3Xd onHost = solveFrame(original, {}).positions;
  std::string table =
      "| | `multigrid`: RMS / largest, % of the diagonal | `reference` |\n| --- | --- | --- |\n";
  /// undone: brings an answer back to where the original's is.
  const auto addRow = [&](const char* words, const StrutGrid& grid, const auto& undone) {
    const Mismatch there =
        mismatchOf(undone(MultigridSolver(device, grid).solve({}).positions), onDevice);
    const Mismatch host = mismatchOf(undone(solveFrame(grid, {}).positions), onHost);
    table += fmt::format("| {} | {:.1e} / {:.1e} | {:.1e} / {:.1e} |\n", words, there.rms,
                         there.largest, host.rms, host.largest);
  };
  const auto same = [](Eigen::Matrix3Xd positions) { return positions; };
  StrutGrid moved = flat;
  transform(moved, Eigen::Translation3d(kShift) *
                       Eigen::Isometry3d(Eigen::AngleAxisd(kTurn, Eigen::Vector3d::UnitZ())));
  addRow("turned in its plane and moved", framed(moved, 1), same);
  addRow("in a unit 25.4 times smaller", framed(inUnit(flat, kUnit), kUnit),
         [](const Eigen::Matrix3Xd& positions) -> Eigen::Matrix3Xd { return positions / kUnit; });
  addRow("mirrored", framed(mirrored(flat), 1),
         [&](const Eigen::Matrix3Xd& positions) { return twinOf(flat.shape, positions); });
  return table;
}

}  // namespace morphgrid
