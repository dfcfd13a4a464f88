#include "benchmark/coarse_costs.h"

#include <functional>

#include "benchmark/cost.h"
#include "solve/coarse_levels.h"
#include "solve/vertex_vector.h"

namespace morphgrid {
namespace {

constexpr int kCycles = 8;  // Recorded at once.

nlohmann::json measure(const std::function<void()>& work, double vertices, int rounds) {
  work();  // Compiles and warms up.
  std::vector<double> wall;
  std::vector<double> cpu;
  for (int round = 0; round < rounds; ++round) {
    const Cost cost = costOf(work);
    wall.push_back(cost.wall);
    cpu.push_back(cost.cpu);
  }
  return {{"wall_ns_per_vertex", median(wall) * 1e9 / vertices},
          {"cpu_ns_per_vertex", median(cpu) * 1e9 / vertices}};
}

}  // namespace

nlohmann::json measureCoarseLevels(const Device& device, const StrutGrid& grid, int rounds) {
  const int vertexCount = grid.shape.vertexCount();
  const DeviceGrid deviceGrid(device, grid);
  const VertexVector residual(device, vertexCount);
  const VertexVector correction(device, vertexCount);
  // Denormals cost a hundred times more: no zeros that rounding leaves.
  upload(device, residual.buffer(), std::vector<vec4>(vertexCount, vec4(0.5F, -0.25F, 0.125F, 0)));
  upload(device, correction.buffer(), std::vector<vec4>(vertexCount, vec4(0)));
  CoarseLevels levels(device, deviceGrid, deviceGrid.positions(), residual.buffer(),
                      correction.buffer());
  nlohmann::json costs;
  costs["coarse_build"] = measure([&] { levels.build(); }, vertexCount, rounds);
  CommandStream stream(device);
  stream.begin();
  for (int n = 0; n < kCycles; ++n) {
    levels.recordCycle(stream);
  }
  stream.end();
  costs["coarse_cycle"] =
      measure([&] { stream.submitAndWait(); }, double(kCycles) * vertexCount, rounds);
  return costs;
}

}  // namespace morphgrid
