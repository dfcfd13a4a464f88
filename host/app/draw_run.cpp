#include "app/draw_run.h"

namespace morphgrid {
namespace {

/// A grid on the device, as far as pictures show it.
struct DrawnGrid {
  Eigen::Matrix3Xd positions;
  std::unique_ptr<DeviceGrid> onDevice;
};

DrawnGrid drawnGrid(const Device& device, const Pictures& pictures, const StrutGrid& grid,
                    const Eigen::Matrix3Xd& positions, const JointRotations& rotations = {}) {
  const ThinnedLattice lattice = pictures.latticeFor(grid);
  if (!lattice.isWhole()) {
    const StrutGrid thinned = lattice.grid(grid, positions);
    return {thinned.positions, std::make_unique<DeviceGrid>(device, thinned)};
  }
  auto onDevice = std::make_unique<DeviceGrid>(device, grid);
  onDevice->uploadPositions(positions, rotations);
  return {positions, std::move(onDevice)};
}

/// The flat stages.
void drawPrinted(const Scene& scene, const SceneDesign& designed, const Simulation& simulation,
                 const Device& device, Pictures& pictures) {
  const RunRecord& record = simulation.record;
  const auto drawn = [&](const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
    return drawnGrid(device, pictures, grid, positions);
  };
  const StrutGrid before = inPlaneGrid(designed.design, scene.weights, scene.scaling);
  const DrawnGrid initial = drawn(before, before.positions);
  pictures.drawInitial(*initial.onDevice, initial.positions);
  const DrawnGrid inPlane = drawn(before, record.inPlane->positions);
  pictures.drawInPlane(*inPlane.onDevice, inPlane.positions);
  const Stage& stage = simulation.stage;
  if (stage.mmPerUnit) pictures.tellLengthsIn({*stage.mmPerUnit, "mm"});
  if (record.full) {
    const DrawnGrid stacked = drawn(stage.grid, stage.grid.positions);
    pictures.drawStacked(*stacked.onDevice, stacked.positions);
    pictures.drawShrink(stage.grid, stage.shrinkBounds);
  }
}

}  // namespace

void drawRun(const Scene& scene, const SceneDesign& designed, const MeshSampling* sampling,
             Simulation& simulation, RunContext& context) {
  Stage& stage = simulation.stage;
  stage.onDevice.reset();  // Its memory is for pictures now.
  context.draw([&](Pictures& pictures) {
    if (sampling) {
      pictures.drawSampling(sampling->mesh, sampling->hits);
    }
    drawPrinted(scene, designed, simulation, *context.device, pictures);
    const Equilibrium& end = stage.equilibrium;
    const DrawnGrid result =
        drawnGrid(*context.device, pictures, stage.grid, end.positions, end.rotations);
    std::optional<Eigen::Matrix3Xd> targets;
    if (designed.targets) targets = pictures.latticeFor(stage.grid).points(*designed.targets);
    pictures.drawResult(*result.onDevice, result.positions, simulation.targetFromGrid, targets);
  });
}

}  // namespace morphgrid
