#include "gpu/command_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/error.h"

namespace morphgrid {
namespace {

constexpr const char* kCopy = "copy";
constexpr const char* kClear = "clear";
constexpr vk::DeviceSize kBytesOfGroup = 1 << 15;  // What copies count as workgroups.

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
    parts_.push_back({std::move(buffers.front()), {}, 0});
  }
  last_ = part;
  parts_[part].work.clear();
  parts_[part].groups = 0;
  parts_[part].commands.reset();
  parts_[part].commands.begin(vk::CommandBufferBeginInfo());
}

/// Timers belong to one command buffer.
bool CommandStream::isCut() const { return device_.pace() && !timer_; }

void CommandStream::count(const CallWork& call) {
  if (isCut() && !parts_[last_].work.empty() &&
      (parts_[last_].groups + call.groups > SubmissionPace::kMostGroups ||
       !device_.pace()->knows(call.kernel))) {
    commands().end();
    beginPart(last_ + 1);
  }
  parts_[last_].work.push_back(call);
  parts_[last_].groups += call.groups;
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
  // Cut between rows, where there are any: shaders may count the groups of a row.
  const bool hasRows = groupsY > 1;
  const std::uint32_t slices = hasRows ? groupsY : groupsX;
  const long sliceGroups = static_cast<long>(hasRows ? groupsX : groupsY) * groupsZ;
  const auto most =
      static_cast<std::uint32_t>(std::max(1L, SubmissionPace::kMostGroups / sliceGroups));
  orderAfterPrevious();
  for (std::uint32_t first = 0; first < slices;) {
    const std::uint32_t count = isCut() ? std::min(most, slices - first) : slices;
    this->count({kernel.name(), count * sliceGroups});
    bind(kernel, push, pushBytes);
    recordTimed(kernel.name(), [&] {
      commands().dispatchBase(hasRows ? 0 : first, hasRows ? first : 0, 0,
                              hasRows ? groupsX : count, hasRows ? count : groupsY, groupsZ);
    });
    first += count;
  }
}

void CommandStream::bind(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes) {
  commands().bindPipeline(vk::PipelineBindPoint::eCompute, kernel.pipeline());
  commands().bindDescriptorSets(vk::PipelineBindPoint::eCompute, kernel.layout(), 0,
                                kernel.descriptorSet(), {});
  if (pushBytes > 0) {
    commands().pushConstants<std::byte>(
        kernel.layout(), vk::ShaderStageFlagBits::eCompute, 0,
        vk::ArrayProxy<const std::byte>(pushBytes, static_cast<const std::byte*>(push)));
  }
}

void CommandStream::copy(const Buffer& from, const Buffer& to, vk::DeviceSize bytes,
                         vk::DeviceSize fromOffset) {
  orderAfterPrevious();
  constexpr vk::DeviceSize kMost = SubmissionPace::kMostGroups * kBytesOfGroup;
  for (vk::DeviceSize done = 0; done < bytes;) {
    const vk::DeviceSize count = isCut() ? std::min(kMost, bytes - done) : bytes;
    this->count({kCopy, static_cast<long>(count / kBytesOfGroup)});
    recordTimed(kCopy, [&] {
      commands().copyBuffer(from.handle(), to.handle(),
                            vk::BufferCopy(fromOffset + done, done, count));
    });
    done += count;
  }
}

void CommandStream::clear(const Buffer& buffer) {
  orderAfterPrevious();
  count({kClear, static_cast<long>(buffer.bytes() / kBytesOfGroup)});
  recordTimed(kClear, [&] { commands().fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 0); });
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
    for (std::size_t first = 0; first <= last_;) {
      const std::size_t end = endOfSubmission(first);
      submitAndWait(first, end);
      first = end;
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

std::size_t CommandStream::endOfSubmission(std::size_t first) const {
  std::size_t end = first + 1;
  if (const SubmissionPace* pace = device_.pace()) {
    double seconds = pace->expect(parts_[first].work);
    while (end <= last_ && (seconds += pace->expect(parts_[end].work)) < SubmissionPace::kLongest) {
      ++end;
    }
  }
  return end;
}

void CommandStream::submitAndWait(std::size_t first, std::size_t end) {
  std::vector<vk::CommandBuffer> commands;
  std::vector<CallWork> work;
  for (std::size_t part = first; part < end; ++part) {
    commands.push_back(*parts_[part].commands);
    work.insert(work.end(), parts_[part].work.begin(), parts_[part].work.end());
  }
  long frameEvents = 0;
  if (const SubmissionPace* pace = device_.pace()) {
    pace->giveWay();
    frameEvents = pace->frameEvents();
  }
  const auto start = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(device_.queueMutex());
    device_.queue().submit(vk::SubmitInfo({}, {}, commands), *fence_);
  }
  const auto forever = std::numeric_limits<std::uint64_t>::max();
  if (device_.handle().waitForFences(*fence_, VK_TRUE, forever) != vk::Result::eSuccess) {
    throw DeviceError(fmt::format("device {} did not finish its work", device_.name()));
  }
  device_.handle().resetFences(*fence_);
  if (device_.pace()) {
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
    device_.pace()->learn(work, waited.count(), frameEvents);
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
