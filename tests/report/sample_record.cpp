#include "tests/report/sample_record.h"

#include <limits>

namespace morphgrid {

RunRecord sampleRecord() {
  RunRecord record;
  record.scene = "sample";
  record.title = "Sample";
  record.method = "jacobi";
  record.scaling = "normalised";
  record.device = "some device";
  record.secondsTotal = 1.5;
  record.grid = {{18, 21, 3}, 0.7, 0.3, 30.9};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  record.measurement = {12.02, 14.84, 0.52, kInfinity, 4};
  record.measurement->cutoffs = {{0.5, 0, kInfinity, 1}, {0.95, 0.4785, 0.418, 1e12}};
  record.measurement->suggestedCutoff = 0.93;
  record.measurement->curvatureNoise = 0.0625;
  Equilibrium stage;
  stage.iterations = 32;
  stage.converged = true;
  stage.reason = StopReason::residual;
  stage.residual = 1e-10;
  stage.energy = 0.1 + 0.2;
  stage.history = {{16, 2.5, 1e-3, 0.25}, {32, stage.energy, 1e-10, 0.5}};
  record.inPlane = stage;
  stage.smallestEigenvalue = {.value = 2e-5, .residual = 1e-6, .iterations = 9, .converged = true};
  record.full = stage;
  record.errors = {1, 2, 3};
  record.distance = {4, 5, {3.5, 4.5, 4.75, 0.5, {2, 1, 0, 0, 0, 0, 0, 0, 0, 1}}};
  record.distance->closest = {6, 7, {}};
  record.symmetry = {Symmetry::mirrorAcrossV, 1e-6, 0.2};
  record.shrink = ShrinkFigures{{31, 0, 2, 0, 0}, {{31, 0, 2, 0, 0}, {}}};
  record.weight = {.newtons = 0.25, .sag = 1.75};
  record.feasibility = Feasibility{};
  return record;
}

}  // namespace morphgrid
