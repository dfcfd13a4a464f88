#include "gpu/vulkan_timer.h"

namespace morphgrid {
namespace {

constexpr std::uint32_t kCallsPerPool = 256;

// After everything before it: calls do not overlap, for barriers are between them.
constexpr auto kStage = vk::PipelineStageFlagBits::eBottomOfPipe;

}  // namespace

void CallTimer::recordStart(const vk::raii::CommandBuffer& commands, const char* name) {
  const std::size_t pool = names_.size() / kCallsPerPool;
  const auto call = static_cast<std::uint32_t>(names_.size() % kCallsPerPool);
  if (pool == pools_.size()) {
    pools_.emplace_back(device_.handles().device,
                        vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2 * kCallsPerPool));
  }
  if (call == 0) {
    commands.resetQueryPool(*pools_[pool], 0, 2 * kCallsPerPool);
  }
  commands.writeTimestamp(kStage, *pools_[pool], 2 * call);
  names_.push_back(name);
}

void CallTimer::recordEnd(const vk::raii::CommandBuffer& commands) {
  const std::size_t last = names_.size() - 1;
  commands.writeTimestamp(kStage, *pools_[last / kCallsPerPool],
                          2 * static_cast<std::uint32_t>(last % kCallsPerPool) + 1);
}

void CallTimer::collect(KernelProfile& profile) const {
  const double secondsPerTick = 1e-9 * device_.handles().properties.limits.timestampPeriod;
  for (std::size_t first = 0; first < names_.size(); first += kCallsPerPool) {
    const std::size_t calls = std::min<std::size_t>(kCallsPerPool, names_.size() - first);
    const auto [result, ticks] = pools_[first / kCallsPerPool].getResults<std::uint64_t>(
        0, static_cast<std::uint32_t>(2 * calls), 2 * calls * sizeof(std::uint64_t),
        sizeof(std::uint64_t), vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    for (std::size_t n = 0; n < calls; ++n) {
      profile.addCall(names_[first + n],
                      static_cast<double>(ticks[2 * n + 1] - ticks[2 * n]) * secondsPerTick);
    }
  }
}

}  // namespace morphgrid
