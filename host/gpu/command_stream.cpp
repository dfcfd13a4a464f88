#include "gpu/command_stream.h"

#include <fmt/format.h>

#include <chrono>
#include <limits>

#include "core/error.h"
#include "gpu/submission_pace.h"

namespace morphgrid {
namespace {

// For SubmissionPace: a call costs as much as some workgroups.
constexpr long kWorkOfCall = 4;
constexpr vk::DeviceSize kBytesPerWork = 1 << 15;

}  // namespace

CommandStream::CommandStream(const Device& device) : device_(device) {
  pool_ = vk::raii::CommandPool(
      device.handle(), vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                                 device.queueFamily()));
  fence_ = vk::raii::Fence(device.handle(), vk::FenceCreateInfo());
  if (device.profile()) {
    timer_.emplace(device);
  }
}

void CommandStream::beginPart(std::size_t part) {
  if (part == parts_.size()) {
    const vk::CommandBufferAllocateInfo one(*pool_, vk::CommandBufferLevel::ePrimary, 1);
    vk::raii::CommandBuffers buffers(device_.handle(), one);
    parts_.push_back({std::move(buffers.front()), 0});
  }
  last_ = part;
  parts_[part].work = 0;
  parts_[part].commands.reset();
  parts_[part].commands.begin(vk::CommandBufferBeginInfo());
}

void CommandStream::count(long work) {
  // Timers belong to one command buffer.
  if (device_.pace() && !timer_ && parts_[last_].work > 0 &&
      parts_[last_].work + work > device_.pace()->most()) {
    commands().end();
    beginPart(last_ + 1);
  }
  parts_[last_].work += work;
}

void CommandStream::begin() {
  beginPart(0);
  if (timer_) {
    timer_->forget();
  }
}

void CommandStream::orderAfterPrevious() {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::MemoryBarrier barrier(
      Access::eShaderWrite | Access::eTransferWrite,
      Access::eShaderRead | Access::eShaderWrite | Access::eTransferRead | Access::eTransferWrite);
  const auto stages = Stage::eComputeShader | Stage::eTransfer;
  commands().pipelineBarrier(stages, stages, {}, barrier, {}, {});
}

void CommandStream::dispatchBytes(const ComputeKernel& kernel, const void* push,
                                  std::uint32_t pushBytes, std::uint32_t groupsX,
                                  std::uint32_t groupsY, std::uint32_t groupsZ) {
  count(kWorkOfCall + static_cast<long>(groupsX) * groupsY * groupsZ);
  commands().bindPipeline(vk::PipelineBindPoint::eCompute, kernel.pipeline());
  commands().bindDescriptorSets(vk::PipelineBindPoint::eCompute, kernel.layout(), 0,
                                kernel.descriptorSet(), {});
  if (pushBytes > 0) {
    commands().pushConstants<std::byte>(
        kernel.layout(), vk::ShaderStageFlagBits::eCompute, 0,
        vk::ArrayProxy<const std::byte>(pushBytes, static_cast<const std::byte*>(push)));
  }
  recordTimed(kernel.name(), [&] { commands().dispatch(groupsX, groupsY, groupsZ); });
}

void CommandStream::copy(const Buffer& from, const Buffer& to, vk::DeviceSize bytes,
                         vk::DeviceSize fromOffset) {
  count(kWorkOfCall + static_cast<long>(bytes / kBytesPerWork));
  recordTimed("copy", [&] {
    commands().copyBuffer(from.handle(), to.handle(), vk::BufferCopy(fromOffset, 0, bytes));
  });
}

void CommandStream::end() {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::MemoryBarrier barrier(Access::eShaderWrite | Access::eTransferWrite, Access::eHostRead);
  commands().pipelineBarrier(Stage::eComputeShader | Stage::eTransfer, Stage::eHost, {}, barrier,
                             {}, {});
  commands().end();
}

void CommandStream::submitAndWait() {
  const auto start = std::chrono::steady_clock::now();
  try {
    for (std::size_t part = 0; part <= last_; ++part) {
      submitAndWait(parts_[part]);
    }
    if (timer_) {
      const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
      device_.profile()->addSubmission(waited.count());
      timer_->collect(*device_.profile());
    }
  } catch (const vk::SystemError& error) {
    throw DeviceError(fmt::format("device {} failed: {}", device_.name(), error.what()));
  }
}

void CommandStream::submitAndWait(const Part& part) {
  const long frameEvents = device_.pace() ? device_.pace()->frameEvents() : 0;
  const auto start = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(device_.queueMutex());
    device_.queue().submit(vk::SubmitInfo({}, {}, *part.commands), *fence_);
  }
  const auto forever = std::numeric_limits<std::uint64_t>::max();
  if (device_.handle().waitForFences(*fence_, VK_TRUE, forever) != vk::Result::eSuccess) {
    throw DeviceError(fmt::format("device {} did not finish its work", device_.name()));
  }
  device_.handle().resetFences(*fence_);
  if (device_.pace()) {
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
    device_.pace()->learn(part.work, waited.count(), frameEvents);
  }
}

void uploadBytes(const Device& device, const Buffer& buffer, const void* data, std::size_t bytes) {
  const Buffer staging(device, bytes, vk::BufferUsageFlagBits::eTransferSrc, MemoryKind::host);
  std::memcpy(staging.mapped<std::byte>().data(), data, bytes);
  CommandStream stream(device);
  stream.begin();
  stream.copy(staging, buffer, bytes);
  stream.end();
  stream.submitAndWait();
}

void downloadBytes(const Device& device, const Buffer& buffer, void* data, std::size_t bytes) {
  const Buffer staging(device, bytes, vk::BufferUsageFlagBits::eTransferDst, MemoryKind::host);
  CommandStream stream(device);
  stream.begin();
  stream.copy(buffer, staging, bytes);
  stream.end();
  stream.submitAndWait();
  std::memcpy(data, staging.mapped<std::byte>().data(), bytes);
}

}  // namespace morphgrid
