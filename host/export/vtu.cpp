#include "export/vtu.h"

#include <cassert>
#include <limits>
#include <vector>

#include "energy/bar_state.h"
#include "export/vtu_file.h"
#include "grid/shrink.h"
#include "grid/strain.h"

namespace morphgrid {
namespace {

void addRestLengths(VtuFile& file, const StrutGrid& grid) {
  file.addDoubles("rest_length",
                  [&](const Strut& strut, std::size_t) { return valueAt(grid.rest, strut); });
}

void addPlaces(VtuFile& file) {
  file.addInts("layer", [](const Strut& strut, std::size_t) { return strut.layer; });
  file.addInts("direction",
               [](const Strut& strut, std::size_t) { return static_cast<int>(strut.direction); });
}

std::vector<BarState> barStatesOf(const StrutGrid& grid, const FramePlacement& place) {
  std::vector<BarState> bars;
  bars.reserve(static_cast<std::size_t>(grid.shape.strutCount()));
  forEachStrut(grid.shape,
               [&](const Strut& strut) { bars.push_back(barStateAt(grid, place, strut)); });
  return bars;
}

/// bars: one a strut, in their order.
void addBarArrays(VtuFile& file, const std::vector<BarState>& bars) {
  const auto add = [&](const char* name, double BarState::*figure) {
    file.addDoubles(name, [&bars, figure](const Strut&, std::size_t n) { return bars[n].*figure; });
  };
  add("axial_energy", &BarState::axialEnergy);
  add("bending_energy", &BarState::bendingEnergy);
  add("shear_energy", &BarState::shearEnergy);
  add("twist_energy", &BarState::twistEnergy);
  add("bending_strain", &BarState::bendingStrain);
  add("joint_rotation", &BarState::jointRotation);
}

/// 3 x vertexCount: NaN but for the layers that stand for the surface, see middleLayer().
Eigen::Matrix3Xd targetsOf(const GridShape& shape, const std::optional<Eigen::Matrix3Xd>& targets) {
  Eigen::Matrix3Xd points =
      Eigen::Matrix3Xd::Constant(3, shape.vertexCount(), std::numeric_limits<double>::quiet_NaN());
  if (targets) {
    layerOf(shape, points, (shape.layers - 1) / 2) = *targets;
    layerOf(shape, points, shape.layers / 2) = *targets;
  }
  return points;
}

}  // namespace

void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  assert(positions.cols() == grid.shape.vertexCount());
  assert(rotations.cols() == (grid.bars ? positions.cols() : 0));
  const StrutValues shrinks = computeShrinks(grid);
  VtuFile file(grid.shape, positions);
  file.addDoubles(
      "strain", [&](const Strut& strut, std::size_t) { return strainAt(grid, positions, strut); });
  addRestLengths(file, grid);
  file.addDoubles("shrink",
                  [&](const Strut& strut, std::size_t) { return valueAt(shrinks, strut); });
  addPlaces(file);
  std::vector<BarState> bars;
  if (grid.bars) {
    bars = barStatesOf(grid, {positions, rotations});
    addBarArrays(file, bars);
  }
  file.write(path);
}

void exportPrintedVtu(const std::filesystem::path& path, const StrutGrid& grid,
                      const Eigen::Matrix3Xd& morphed,
                      const std::optional<Eigen::Matrix3Xd>& targets) {
  assert(morphed.cols() == grid.shape.vertexCount());
  assert(!targets || targets->cols() == grid.shape.layerVertexCount());
  const Eigen::Matrix3Xd points = targetsOf(grid.shape, targets);
  VtuFile file(grid.shape, grid.positions);
  file.addPointArray("morphed", morphed);
  file.addPointArray("target", points);
  addRestLengths(file, grid);
  file.addDoubles("printed_length",
                  [&](const Strut& strut, std::size_t) { return lengthAt(grid.positions, strut); });
  addPlaces(file);
  file.write(path);
}

}  // namespace morphgrid
