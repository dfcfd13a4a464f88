#include "gpu/command_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/error.h"
#include "gpu/submission_pace.h"
#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_program.h"
#include "gpu/vulkan_timer.h"

namespace morphgrid {
namespace {

constexpr const char* kCopy = "copy";
constexpr const char* kClear = "clear";
constexpr std::uint64_t kBytesOfGroup = 1 << 15;  // What copies count as workgroups.

}  // namespace

class CommandStream::Recorder {
 public:
  explicit Recorder(const Device& device);

  void begin();
  void dispatch(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes,
                std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t groupsZ);
  void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes, std::uint64_t fromOffset);
  void clear(const Buffer& buffer);
  void end();
  void submitAndWait();
  const CommandBuffer& commands() const { return parts_[last_].commands; }

 private:
  /// What cannot be submitted but at once.
  struct Part {
    CommandBuffer commands;
    std::vector<CallWork> work;
    long groups = 0;
  };

  bool isCut() const;
  void beginPart(std::size_t part);
  /// A call that is to be recorded.
  void count(const CallWork& call);
  /// The first part that is not to be submitted together with `first`.
  std::size_t endOfSubmission(std::size_t first) const;
  void submitAndWait(std::size_t first, std::size_t end);
  void orderAfterPrevious();
  void bind(const ComputeKernel& kernel, const void* push, std::uint32_t pushBytes);
  /// record(): one command, timed where the device keeps a profile.
  template <typename Record>
  void recordTimed(const char* name, Record record) {
    if (timer_) {
      timer_->recordStart(commands(), name);
    }
    record();
    if (timer_) {
      timer_->recordEnd(commands());
    }
  }

  const Device& device_;
  vk::raii::CommandPool pool_;
  std::vector<Part> parts_;
  std::size_t last_ = 0;  ///< Index of the last part in use.
  vk::raii::Fence fence_;
  std::optional<CallTimer> timer_;
};

CommandStream::Recorder::Recorder(const Device& device)
    : device_(device),
      pool_(createCommandPool(device.handles().device, device.handles().queueFamily)),
      fence_(device.handles().device, vk::FenceCreateInfo()) {
  if (device.profile()) {
    timer_.emplace(device);
  }
}

void CommandStream::Recorder::beginPart(std::size_t part) {
  if (part == parts_.size()) {
    parts_.push_back({CommandBuffer(device_.handles().device, pool_), {}, 0});
  }
  last_ = part;
  parts_[part].work.clear();
  parts_[part].groups = 0;
  parts_[part].commands.reset();
  parts_[part].commands.begin(vk::CommandBufferBeginInfo());
}

/// Timers belong to one command buffer.
bool CommandStream::Recorder::isCut() const { return device_.pace() && !timer_; }

void CommandStream::Recorder::count(const CallWork& call) {
  if (isCut() && !parts_[last_].work.empty() &&
      (parts_[last_].groups + call.groups > SubmissionPace::kMostGroups ||
       !device_.pace()->knows(call.kernel))) {
    commands().end();
    beginPart(last_ + 1);
  }
  parts_[last_].work.push_back(call);
  parts_[last_].groups += call.groups;
}

void CommandStream::Recorder::begin() {
  beginPart(0);
  if (timer_) {
    timer_->forget();
  }
}

void CommandStream::Recorder::orderAfterPrevious() {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::MemoryBarrier barrier(
      Access::eShaderWrite | Access::eTransferWrite,
      Access::eShaderRead | Access::eShaderWrite | Access::eTransferRead | Access::eTransferWrite);
  const auto stages = Stage::eComputeShader | Stage::eTransfer;
  commands().pipelineBarrier(stages, stages, {}, barrier, {}, {});
}

void CommandStream::Recorder::dispatch(const ComputeKernel& kernel, const void* push,
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

void CommandStream::Recorder::bind(const ComputeKernel& kernel, const void* push,
                                   std::uint32_t pushBytes) {
  const KernelProgram& program = kernel.program();
  const vk::DescriptorSet set = kernel.resources().handle();
  commands().bindPipeline(vk::PipelineBindPoint::eCompute, device_.programs().await(program));
  commands().bindDescriptorSets(vk::PipelineBindPoint::eCompute, *program.layout, 0, set, {});
  if (pushBytes > 0) {
    commands().pushConstants<std::byte>(
        *program.layout, vk::ShaderStageFlagBits::eCompute, 0,
        vk::ArrayProxy<const std::byte>(pushBytes, static_cast<const std::byte*>(push)));
  }
}

void CommandStream::Recorder::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes,
                                   std::uint64_t fromOffset) {
  orderAfterPrevious();
  constexpr std::uint64_t kMost = SubmissionPace::kMostGroups * kBytesOfGroup;
  for (std::uint64_t done = 0; done < bytes;) {
    const std::uint64_t count = isCut() ? std::min(kMost, bytes - done) : bytes;
    this->count({kCopy, static_cast<long>(count / kBytesOfGroup)});
    recordTimed(kCopy, [&] {
      commands().copyBuffer(from.handle(), to.handle(),
                            vk::BufferCopy(fromOffset + done, done, count));
    });
    done += count;
  }
}

void CommandStream::Recorder::clear(const Buffer& buffer) {
  orderAfterPrevious();
  count({kClear, static_cast<long>(buffer.bytes() / kBytesOfGroup)});
  recordTimed(kClear, [&] { commands().fillBuffer(buffer.handle(), 0, VK_WHOLE_SIZE, 0); });
}

void CommandStream::Recorder::end() {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::MemoryBarrier barrier(Access::eShaderWrite | Access::eTransferWrite, Access::eHostRead);
  commands().pipelineBarrier(Stage::eComputeShader | Stage::eTransfer, Stage::eHost, {}, barrier,
                             {}, {});
  commands().end();
}

void CommandStream::Recorder::submitAndWait() {
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

std::size_t CommandStream::Recorder::endOfSubmission(std::size_t first) const {
  std::size_t end = first + 1;
  if (const SubmissionPace* pace = device_.pace()) {
    double seconds = pace->expect(parts_[first].work);
    while (end <= last_ && (seconds += pace->expect(parts_[end].work)) < SubmissionPace::kLongest) {
      ++end;
    }
  }
  return end;
}

void CommandStream::Recorder::submitAndWait(std::size_t first, std::size_t end) {
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
    device_.handles().queue.submit(vk::SubmitInfo({}, {}, commands), *fence_);
  }
  const auto forever = std::numeric_limits<std::uint64_t>::max();
  if (device_.handles().device.waitForFences(*fence_, VK_TRUE, forever) != vk::Result::eSuccess) {
    throw DeviceError(fmt::format("device {} did not finish its work", device_.name()));
  }
  device_.handles().device.resetFences(*fence_);
  if (device_.pace()) {
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
    device_.pace()->learn(work, waited.count(), frameEvents);
  }
}

CommandStream::CommandStream(const Device& device)
    : recorder_(std::make_unique<Recorder>(device)) {}

CommandStream::~CommandStream() = default;
CommandStream::CommandStream(CommandStream&&) noexcept = default;

void CommandStream::begin() { recorder_->begin(); }

void CommandStream::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes,
                         std::uint64_t fromOffset) {
  recorder_->copy(from, to, bytes, fromOffset);
}

void CommandStream::clear(const Buffer& buffer) { recorder_->clear(buffer); }

void CommandStream::end() { recorder_->end(); }

void CommandStream::submitAndWait() { recorder_->submitAndWait(); }

const CommandBuffer& CommandStream::commands() const { return recorder_->commands(); }

void CommandStream::dispatchBytes(const ComputeKernel& kernel, const void* push,
                                  std::uint32_t pushBytes, std::uint32_t groupsX,
                                  std::uint32_t groupsY, std::uint32_t groupsZ) {
  recorder_->dispatch(kernel, push, pushBytes, groupsX, groupsY, groupsZ);
}

void uploadBytes(const Device& device, const Buffer& buffer, const void* data, std::size_t bytes) {
  const Buffer staging(device, bytes, BufferUsage::transferSrc, MemoryKind::host);
  std::memcpy(staging.mapped<std::byte>().data(), data, bytes);
  CommandStream stream(device);
  stream.begin();
  stream.copy(staging, buffer, bytes);
  stream.end();
  stream.submitAndWait();
}

void downloadBytes(const Device& device, const Buffer& buffer, void* data, std::size_t bytes) {
  const Buffer staging(device, bytes, BufferUsage::transferDst, MemoryKind::host);
  CommandStream stream(device);
  stream.begin();
  stream.copy(buffer, staging, bytes);
  stream.end();
  stream.submitAndWait();
  std::memcpy(data, staging.mapped<std::byte>().data(), bytes);
}

}  // namespace morphgrid
