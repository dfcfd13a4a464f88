#include "app/draw_run.h"

namespace morphgrid {
namespace {

/// The flat stages.
void drawPrinted(const Scene& scene, const SceneDesign& designed, const Simulation& simulation,
                 const Device& device, Pictures& pictures) {
  const RunRecord& record = simulation.record;
  const StrutGrid before = inPlaneGrid(designed.design, scene.weights, scene.scaling);
  DeviceGrid inPlane(device, before);
  pictures.drawInitial(inPlane, before.positions);
  inPlane.uploadPositions(record.inPlane->positions);
  pictures.drawInPlane(inPlane, record.inPlane->positions);
  const Stage& stage = simulation.stage;
  if (stage.mmPerUnit) pictures.tellLengthsIn({*stage.mmPerUnit, "mm"});
  if (record.full) {
    pictures.drawStacked(DeviceGrid(device, stage.grid), stage.grid.positions);
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
    stage.onDevice = std::make_shared<DeviceGrid>(*context.device, stage.grid);
    stage.onDevice->uploadPositions(stage.equilibrium.positions, stage.equilibrium.rotations);
    pictures.drawResult(*stage.onDevice, stage.equilibrium.positions, simulation.targetFromGrid,
                        designed.targets);
  });
}

}  // namespace morphgrid
