#include "gpu/presenter.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gpu/submission_pace.h"

namespace morphgrid {
namespace {

constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();

constexpr std::uint64_t kPatience = 1'000'000'000;  // ns, for an image: some screens give none.

/// Colours go to the screen as the shaders write them, as they do in pictures.
vk::SurfaceFormatKHR chooseFormat(const Device& device, vk::SurfaceKHR surface) {
  const auto formats = device.physical().getSurfaceFormatsKHR(surface);
  for (const vk::SurfaceFormatKHR& format : formats) {
    if (format.format == vk::Format::eB8G8R8A8Unorm ||
        format.format == vk::Format::eR8G8B8A8Unorm) {
      return format;
    }
  }
  throw DeviceError(fmt::format("device {} has no plain 8-bit colours for this window; {}",
                                device.name(), "`morphgrid run` needs no window"));
}

[[noreturn]] void fail(const Device& device, const vk::SystemError& error) {
  throw DeviceError(
      fmt::format("device {} cannot draw into the window: {}", device.name(), error.what()));
}

}  // namespace

Presenter::Presenter(const Device& device, vk::raii::SurfaceKHR surface)
    : device_(device), surface_(std::move(surface)) {
  if (!device.physical().getSurfaceSupportKHR(device.queueFamily(), *surface_)) {
    throw DeviceError(fmt::format("device {} cannot draw into this window; {}", device.name(),
                                  "`morphgrid run` needs no window"));
  }
  format_ = chooseFormat(device, *surface_);
  pool_ = vk::raii::CommandPool(
      device.handle(), vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                                 device.queueFamily()));
  const vk::CommandBufferAllocateInfo one(*pool_, vk::CommandBufferLevel::ePrimary, 1);
  commands_ = std::move(vk::raii::CommandBuffers(device.handle(), one).front());
  drawn_ =
      vk::raii::Fence(device.handle(), vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled));
  acquired_ = vk::raii::Semaphore(device.handle(), vk::SemaphoreCreateInfo());
}

Presenter::~Presenter() {
  const std::lock_guard lock(device_.queueMutex());
  // Vulkan's own function: a destructor must not throw when the device is lost.
  device_.handle().getDispatcher()->vkDeviceWaitIdle(*device_.handle());
}

std::vector<vk::ImageView> Presenter::views() const {
  std::vector<vk::ImageView> views;
  for (const auto& view : views_) {
    views.push_back(*view);
  }
  return views;
}

void Presenter::waitForLast() {
  if (device_.handle().waitForFences(*drawn_, VK_TRUE, kForever) != vk::Result::eSuccess) {
    throw DeviceError(fmt::format("device {} did not finish a picture", device_.name()));
  }
  if (device_.pace()) {
    device_.pace()->endFrame();
  }
}

bool Presenter::prepare(vk::Extent2D windowSize) {
  if (!isOutdated_ && windowSize == size_) {
    return true;
  }
  try {
    const auto capabilities = device_.physical().getSurfaceCapabilitiesKHR(*surface_);
    // Where the surface has no size of its own, it takes the swapchain's.
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    const vk::Extent2D size =
        capabilities.currentExtent.width == kNone ? windowSize : capabilities.currentExtent;
    if (size.width == 0 || size.height == 0) {
      return false;
    }
    createSwapchain(capabilities, size);
  } catch (const vk::SystemError& error) {
    fail(device_, error);
  }
  return true;
}

void Presenter::createSwapchain(const vk::SurfaceCapabilitiesKHR& capabilities, vk::Extent2D size) {
  waitForLast();
  {
    const std::lock_guard lock(device_.queueMutex());
    device_.queue().waitIdle();
  }
  const std::uint32_t most = capabilities.maxImageCount > 0 ? capabilities.maxImageCount : 3;
  vk::SwapchainCreateInfoKHR info({}, *surface_, std::min(capabilities.minImageCount + 1, most),
                                  format_.format, format_.colorSpace, size, 1,
                                  vk::ImageUsageFlagBits::eColorAttachment);
  info.preTransform = capabilities.currentTransform;
  info.clipped = VK_TRUE;
  info.oldSwapchain = *swapchain_;
  vk::raii::SwapchainKHR swapchain(device_.handle(), info);
  views_.clear();
  rendered_.clear();
  swapchain_ = std::move(swapchain);
  for (const VkImage image : swapchain_.getImages()) {
    views_.emplace_back(device_.handle(),
                        vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format_.format,
                                                {}, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    rendered_.emplace_back(device_.handle(), vk::SemaphoreCreateInfo());
  }
  size_ = size;
  isOutdated_ = false;
  ++generation_;
}

bool Presenter::present(
    const std::function<void(const vk::raii::CommandBuffer&, std::size_t)>& record) {
  try {
    waitForLast();
    const auto image = acquire();
    if (!image) {
      return false;
    }
    commands_.reset();
    commands_.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    record(commands_, *image);
    commands_.end();
    submit(*image);
    return show(*image);
  } catch (const vk::SystemError& error) {
    fail(device_, error);
  }
}

std::optional<std::uint32_t> Presenter::acquire() {
  try {
    const auto [result, image] = swapchain_.acquireNextImage(kPatience, *acquired_);
    isOutdated_ = result == vk::Result::eSuboptimalKHR;
    return result == vk::Result::eSuccess || isOutdated_ ? std::optional(image) : std::nullopt;
  } catch (const vk::OutOfDateKHRError&) {
    isOutdated_ = true;
    return std::nullopt;
  }
}

void Presenter::submit(std::uint32_t image) {
  const vk::PipelineStageFlags drawing = vk::PipelineStageFlagBits::eColorAttachmentOutput;
  device_.handle().resetFences(*drawn_);
  if (device_.pace()) {
    device_.pace()->beginFrame();
  }
  const std::lock_guard lock(device_.queueMutex());
  device_.queue().submit(vk::SubmitInfo(*acquired_, drawing, *commands_, *rendered_[image]),
                         *drawn_);
}

bool Presenter::show(std::uint32_t image) {
  try {
    const std::lock_guard lock(device_.queueMutex());
    const auto result =
        device_.queue().presentKHR(vk::PresentInfoKHR(*rendered_[image], *swapchain_, image));
    isOutdated_ |= result == vk::Result::eSuboptimalKHR;
  } catch (const vk::OutOfDateKHRError&) {
    isOutdated_ = true;
  }
  return !isOutdated_;
}

}  // namespace morphgrid
