#include "gpu/command_stream.h"

#include <fmt/format.h>

#include <chrono>
#include <limits>

#include "core/error.h"

namespace morphgrid {

CommandStream::CommandStream(const Device& device) : device_(device) {
  pool_ = vk::raii::CommandPool(
      device.handle(), vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                                 device.queueFamily()));
  commands_ = std::move(
      vk::raii::CommandBuffers(device.handle(), vk::CommandBufferAllocateInfo(
                                                    *pool_, vk::CommandBufferLevel::ePrimary, 1))
          .front());
  fence_ = vk::raii::Fence(device.handle(), vk::FenceCreateInfo());
  if (device.profile()) {
    timer_.emplace(device);
  }
}

void CommandStream::begin() {
  commands_.reset();
  commands_.begin(vk::CommandBufferBeginInfo());
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
  commands_.pipelineBarrier(stages, stages, {}, barrier, {}, {});
}

void CommandStream::dispatchBytes(const ComputeKernel& kernel, const void* push,
                                  std::uint32_t pushBytes, std::uint32_t groupsX,
                                  std::uint32_t groupsY, std::uint32_t groupsZ) {
  commands_.bindPipeline(vk::PipelineBindPoint::eCompute, kernel.pipeline());
  commands_.bindDescriptorSets(vk::PipelineBindPoint::eCompute, kernel.layout(), 0,
                               kernel.descriptorSet(), {});
  if (pushBytes > 0) {
    commands_.pushConstants<std::byte>(
        kernel.layout(), vk::ShaderStageFlagBits::eCompute, 0,
        vk::ArrayProxy<const std::byte>(pushBytes, static_cast<const std::byte*>(push)));
  }
  recordTimed(kernel.name(), [&] { commands_.dispatch(groupsX, groupsY, groupsZ); });
}

void CommandStream::copy(const Buffer& from, const Buffer& to, vk::DeviceSize bytes,
                         vk::DeviceSize fromOffset) {
  recordTimed("copy", [&] {
    commands_.copyBuffer(from.handle(), to.handle(), vk::BufferCopy(fromOffset, 0, bytes));
  });
}

void CommandStream::end() {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::MemoryBarrier barrier(Access::eShaderWrite | Access::eTransferWrite, Access::eHostRead);
  commands_.pipelineBarrier(Stage::eComputeShader | Stage::eTransfer, Stage::eHost, {}, barrier, {},
                            {});
  commands_.end();
}

void CommandStream::submitAndWait() {
  const auto start = std::chrono::steady_clock::now();
  try {
    device_.queue().submit(vk::SubmitInfo({}, {}, *commands_), *fence_);
    const auto forever = std::numeric_limits<std::uint64_t>::max();
    if (device_.handle().waitForFences(*fence_, VK_TRUE, forever) != vk::Result::eSuccess) {
      throw DeviceError(fmt::format("device {} did not finish its work", device_.name()));
    }
    device_.handle().resetFences(*fence_);
    if (timer_) {
      const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
      device_.profile()->addSubmission(waited.count());
      timer_->collect(*device_.profile());
    }
  } catch (const vk::SystemError& error) {
    throw DeviceError(fmt::format("device {} failed: {}", device_.name(), error.what()));
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
