#include "benchmark/kernel_costs.h"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <string>

#include "benchmark/cost.h"
#include "solve/grid_gradient.h"
#include "solve/grid_hessian.h"

namespace morphgrid {
namespace {

constexpr int kRepetitions = 16;  // Recorded at once.

struct Kernel {
  std::string name;  ///< Also the key in the file of results.
  std::function<void(CommandStream&)> record;
};

nlohmann::json measure(const Device& device, const Kernel& kernel, int vertexCount, int rounds) {
  CommandStream stream(device);
  stream.begin();
  for (int n = 0; n < kRepetitions; ++n) {
    kernel.record(stream);
  }
  stream.end();
  stream.submitAndWait();  // Compiles and warms up.
  std::vector<double> wall;
  std::vector<double> cpu;
  for (int round = 0; round < rounds; ++round) {
    const Cost cost = costOf([&] { stream.submitAndWait(); });
    wall.push_back(cost.wall);
    cpu.push_back(cost.cpu);
  }
  const double toNanoseconds = 1e9 / (double(kRepetitions) * vertexCount);
  return {{"wall_ns_per_vertex", median(wall) * toNanoseconds},
          {"cpu_ns_per_vertex", median(cpu) * toNanoseconds}};
}

}  // namespace

nlohmann::json measureKernels(const Device& device, const StrutGrid& grid, int rounds) {
  const DeviceGrid deviceGrid(device, grid);
  const int vertexCount = grid.shape.vertexCount();
  const VertexVector b(device, vertexCount);
  const VertexVector z(device, vertexCount);
  const VertexVector r(device, vertexCount);
  GridHessian hessian(device, deviceGrid);
  const auto hessianStep = [&](GridHessian::Step step) {
    const auto shared = std::make_shared<GridHessian::Step>(std::move(step));
    return [&hessian, shared](CommandStream& stream) { hessian.record(stream, *shared); };
  };
  upload(device, b.buffer(), std::vector<vec4>(vertexCount, vec4(0.5F, -0.25F, 0.125F, 0)));
  upload(device, z.buffer(), std::vector<vec4>(vertexCount, vec4(0.125F, 0.5F, -0.25F, 0)));
  GridGradient single(device, deviceGrid, Precision::single);
  const auto singleStep = single.evaluation(deviceGrid.positions(), r);
  std::vector<Kernel> kernels{
      {"gradient", [&](CommandStream& stream) { single.record(stream, singleStep); }},
      {"linearisation",
       [&](CommandStream& stream) { hessian.recordLinearisation(stream, deviceGrid.positions()); }},
      {"product", hessianStep(hessian.product(z, r))},
      {"residual", hessianStep(hessian.residual(z, b, r))},
      {"smoothing", hessianStep(hessian.smoothing(z, b, r))},
      {"first_smoothing", hessianStep(hessian.firstSmoothing(b, r))}};
  nlohmann::json costs;
  for (const Kernel& kernel : kernels) {
    costs[kernel.name] = measure(device, kernel, vertexCount, rounds);
  }
  if (device.hasFloat64()) {
    GridGradient precise(device, deviceGrid, Precision::precise);
    const auto step = precise.evaluation(deviceGrid.positions(), r);
    costs["gradient_precise"] =
        measure(device, {"", [&](CommandStream& stream) { precise.record(stream, step); }},
                vertexCount, rounds);
  }
  return costs;
}

void printKernels(const nlohmann::json& kernels) {
  for (const auto& [name, cost] : kernels.items()) {
    fmt::print("          {:<16} {:>9.1f}        {:>10.1f}\n", name,
               cost["wall_ns_per_vertex"].get<double>(), cost["cpu_ns_per_vertex"].get<double>());
  }
}

}  // namespace morphgrid
