#include "benchmark/machine_benchmark.h"

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "benchmark/cost.h"
#include "core/atomic_file.h"
#include "gpu/command_stream.h"
#include "probe/arithmetic_comp.h"
#include "probe/stream_comp.h"
#include "shared/probe_types.h"

namespace morphgrid {
namespace {

constexpr std::uint32_t kStreamed = 1 << 22;  // vec4: 64 MiB, more than caches hold.
constexpr std::uint32_t kComputed = 1 << 18;  // Invocations.
constexpr int kRepetitions = 4;               // Recorded at once.

struct MachineBenchmark {
  int rounds = 9;
  std::string device;
  std::string jsonFile;
};

/// Buffers for a kernel that turns every vec4 into another.
struct Probe {
  Probe(const Device& device, ShaderCode spirv, std::uint32_t count)
      : source(device, count * sizeof(vec4),
               BufferUsage::storageTexelBuffer | BufferUsage::transferDst, MemoryKind::device),
        destination(device, count * sizeof(vec4), BufferUsage::storageBuffer, MemoryKind::device),
        texels(device, source, TexelFormat::float4, TexelAccess::image),
        kernel(device, spirv, {{kBindingSource, &texels}, {kBindingDestination, &destination}}, 0),
        stream(device) {
    // Below 1: no step may lead to infinity or to denormals, which are slow.
    upload(device, source, std::vector<vec4>(count, vec4(0.5F, 0.25F, 0.75F, 0.125F)));
    stream.begin();
    for (int n = 0; n < kRepetitions; ++n) {
      stream.dispatch(kernel, count / kProbeInvocations);
    }
    stream.end();
  }

  Buffer source;
  Buffer destination;
  TexelView texels;
  ComputeKernel kernel;
  CommandStream stream;
};

/// Median seconds, after a first round that warms up.
template <typename Work>
double secondsOf(int rounds, Work work) {
  work();
  std::vector<double> wall;
  for (int round = 0; round < rounds; ++round) {
    wall.push_back(costOf(work).wall);
  }
  return median(std::move(wall));
}

/// Bytes read and written per second.
double deviceBandwidth(const Device& device, int rounds) {
  Probe probe(device, stream_comp_spirv, kStreamed);
  const double bytes = 2.0 * kRepetitions * kStreamed * sizeof(vec4);
  return bytes / secondsOf(rounds, [&] { probe.stream.submitAndWait(); });
}

/// Operations in single precision per second.
double deviceArithmetic(const Device& device, int rounds) {
  Probe probe(device, arithmetic_comp_spirv, kComputed);
  const double flops = 1.0 * kRepetitions * kComputed * kProbeSteps * kFlopsPerStep;
  return flops / secondsOf(rounds, [&] { probe.stream.submitAndWait(); });
}

/// Bytes read and written per second by memcpy on all processors.
double hostBandwidth(int rounds) {
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t share = kStreamed * sizeof(vec4) / threads;
  const std::vector<std::byte> source(threads * share, std::byte{1});
  std::vector<std::byte> destination(threads * share);
  const double seconds = secondsOf(rounds, [&] {
    std::vector<std::jthread> workers;
    for (std::size_t n = 0; n < threads; ++n) {
      workers.emplace_back(
          [&, n] { std::memcpy(&destination[n * share], &source[n * share], share); });
    }
  });
  return 2.0 * static_cast<double>(threads * share) / seconds;
}

void run(const MachineBenchmark& options) {
  const Device device({.selection = options.device});
  const nlohmann::json result{{"device", device.name()},
                              {"device_bytes_per_second", deviceBandwidth(device, options.rounds)},
                              {"device_flops", deviceArithmetic(device, options.rounds)},
                              {"host_bytes_per_second", hostBandwidth(options.rounds)}};
  const auto giga = [&](const char* key) { return 1e-9 * result[key].get<double>(); };
  fmt::print(
      "device: {}\nmedians of {} rounds\n"
      "device, copying texels (bytes read and written): {:.1f} GB/s\n"
      "device, multiply and add in single precision:    {:.1f} Gflop/s\n"
      "processor, memcpy on all threads:                {:.1f} GB/s\n",
      device.name(), options.rounds, giga("device_bytes_per_second"), giga("device_flops"),
      giga("host_bytes_per_second"));
  if (!options.jsonFile.empty()) {
    writeFileAtomically(options.jsonFile, result.dump(2));
  }
}

}  // namespace

void addMachineBenchmark(CLI::App& app) {
  const auto options = std::make_shared<MachineBenchmark>();
  CLI::App* machine = app.add_subcommand(
      "machine", "Measures how many bytes the device moves and how much it computes in a second.");
  machine->add_option("--rounds", options->rounds, "repetitions; medians are printed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  machine->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  machine->add_option("--json", options->jsonFile, "also write the figures to this file");
  machine->callback([options] { run(*options); });
}

}  // namespace morphgrid
