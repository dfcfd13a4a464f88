#include "tests/state/sample_state.h"

#include <cmath>

#include "design/build_grids.h"

namespace morphgrid {
namespace {

/// A number for each of many, none like the other.
Eigen::Matrix3Xd wave(const Eigen::Matrix3Xd& points, double amplitude) {
  Eigen::Matrix3Xd moved = points;
  for (Eigen::Index n = 0; n < moved.cols(); ++n) {
    moved.col(n) += amplitude * Eigen::Vector3d(std::sin(1.0 + n), std::sin(2.0 * n), std::cos(n));
  }
  return moved;
}

GridDesign sampleDesign(int layers) {
  return designFromBendAngles({.nodesU = 3,
                               .nodesV = 2,
                               .spacing = 1.25,
                               .firstThetaU = 0.1,
                               .lastThetaU = 0.3,
                               .firstThetaV = -0.2,
                               .lastThetaV = 0},
                              layers, 0.3);
}

Equilibrium equilibriumAt(Eigen::Matrix3Xd positions) {
  Equilibrium equilibrium;
  equilibrium.positions = std::move(positions);
  equilibrium.iterations = 12;
  equilibrium.converged = true;
  equilibrium.reason = StopReason::energy;
  equilibrium.residual = 1.25e-10;
  equilibrium.energy = 0.1 + 0.2;
  equilibrium.seconds = 0.75;
  equilibrium.history = {{1, 2.5, 0.5, 0.25, 0.0625}, {12, 0.3, 1e-10, 0.5, 1}};
  return equilibrium;
}

RunState stateOf(GridDesign design, const Eigen::Matrix3Xd& printedLayer, StrutGrid grid) {
  RunState state{.program = "morphgrid 0.1.0",
                 .scene = "title = \"\u00dcbung\"\n",
                 .sceneFile = "/some/where/sample.toml",
                 .design = std::move(design),
                 .targets = {},
                 .sampling = {},
                 .grid = std::move(grid),
                 .targetFromGrid = Eigen::Translation3d(1, 2, 3) *
                                   Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()),
                 .record = {}};
  RunRecord& record = state.record;
  record.scene = "sample";
  record.title = "Sample";
  record.method = "multigrid";
  record.scaling = "normalised";
  record.device = "some device";
  record.grid = {state.grid.shape, state.design.spacing, state.design.layerSpacing, 12.5};
  record.inPlane = equilibriumAt(printedLayer);
  record.notices = {"a notice"};
  return state;
}

RunState stackedState(Scaling scaling) {
  GridDesign design = sampleDesign(3);
  const StrutGrid flat = inPlaneGrid(design, {}, scaling);
  const Eigen::Matrix3Xd printedLayer = wave(flat.positions, 0.01);
  StrutGrid grid = stackedGrid(design, {}, scaling, printedLayer);
  RunState state = stateOf(std::move(design), printedLayer, std::move(grid));
  state.record.full = equilibriumAt(wave(state.grid.positions, 0.1));
  state.record.full->iterations = 34;
  return state;
}

}  // namespace

RunState plainState() { return stackedState(Scaling::normalised); }

RunState sampleState() {
  RunState state = stackedState(Scaling::shapeop);
  state.grid.rest.u[0] *= 0.5;
  state.record.printScale = 1.125;
  state.record.inverse = InverseDesign{{}, {}, {{InverseStep::Kind::design}}, "all steps done", {}};
  state.targets = wave(state.record.inPlane->positions, 0.2);
  JointRotations& rotations = state.record.full->rotations;
  rotations = JointRotations::Random(4, state.grid.shape.vertexCount());
  rotations.colwise().normalize();
  state.angleErrors = Eigen::VectorXd::Random(state.grid.shape.layerVertexCount());
  MeshSampling& sampling = state.sampling.emplace();
  sampling.mesh.vertices = Eigen::Matrix3Xd::Random(3, 4);
  sampling.mesh.triangles.resize(3, 2);
  sampling.mesh.triangles << 0, 1, 1, 2, 2, 3;
  sampling.hits = {{0.5, 0.25, 2, 3}, 3, 2, Eigen::Matrix3Xd::Random(3, 6), {1, 1, 0, 1, 1, 0}};
  return state;
}

RunState flatState() {
  GridDesign design = sampleDesign(1);
  StrutGrid grid = inPlaneGrid(design, {}, Scaling::normalised);
  const Eigen::Matrix3Xd positions = wave(grid.positions, 0.01);
  return stateOf(std::move(design), positions, std::move(grid));
}

}  // namespace morphgrid
