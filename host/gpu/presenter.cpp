#include "gpu/presenter.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gpu/submission_pace.h"
#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_pass.h"

namespace morphgrid {
namespace {

constexpr auto kForever = std::numeric_limits<std::uint64_t>::max();

constexpr std::uint64_t kPatience = 1'000'000'000;  // ns, for an image: some screens give none.

/// Colours go to the screen as the shaders write them, as they do in pictures.
vk::SurfaceFormatKHR chooseFormat(const Device& device, vk::SurfaceKHR surface) {
  const DeviceHandles& handles = device.handles();
  if (!handles.physical.getSurfaceSupportKHR(handles.queueFamily, surface)) {
    throw DeviceError(fmt::format("device {} cannot draw into this window; {}", device.name(),
                                  "`morphgrid run` needs no window"));
  }
  const auto formats = device.handles().physical.getSurfaceFormatsKHR(surface);
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

struct Presenter::Handles {
  Handles(const Device& device, VkSurfaceKHR windowSurface)
      : surface(device.handles().instance, windowSurface),
        format(chooseFormat(device, *surface)),
        pool(createCommandPool(device.handles().device, device.handles().queueFamily)),
        commands(device.handles().device, pool),
        drawn(device.handles().device, vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled)),
        acquired(device.handles().device, vk::SemaphoreCreateInfo()) {}

  vk::raii::SurfaceKHR surface;
  vk::SurfaceFormatKHR format;
  vk::raii::CommandPool pool;
  CommandBuffer commands;
  vk::raii::Fence drawn;
  vk::raii::Semaphore acquired;
  vk::raii::SwapchainKHR swapchain = nullptr;
  std::vector<vk::raii::ImageView> views;
  std::vector<vk::raii::Semaphore> rendered;  ///< One an image: its last showing may still wait.

  void createSwapchain(const vk::raii::Device& device,
                       const vk::SurfaceCapabilitiesKHR& capabilities, PixelSize size) {
    const std::uint32_t most = capabilities.maxImageCount > 0 ? capabilities.maxImageCount : 3;
    vk::SwapchainCreateInfoKHR info({}, *surface, std::min(capabilities.minImageCount + 1, most),
                                    format.format, format.colorSpace, {size.width, size.height}, 1,
                                    vk::ImageUsageFlagBits::eColorAttachment);
    info.preTransform = capabilities.currentTransform;
    info.clipped = VK_TRUE;
    info.oldSwapchain = *swapchain;
    vk::raii::SwapchainKHR next(device, info);
    views.clear();
    rendered.clear();
    swapchain = std::move(next);
    for (const VkImage image : swapchain.getImages()) {
      views.emplace_back(
          device, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format.format, {},
                                          {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
      rendered.emplace_back(device, vk::SemaphoreCreateInfo());
    }
  }
};

Presenter::Presenter(const Device& device, VkSurfaceKHR surface)
    : device_(device), handles_(std::make_unique<Handles>(device, surface)) {}

Presenter::~Presenter() {
  const std::lock_guard lock(device_.queueMutex());
  // Vulkan's own function: a destructor must not throw when the device is lost.
  device_.handles().device.getDispatcher()->vkDeviceWaitIdle(*device_.handles().device);
}

ColorFormat Presenter::format() const {
  return handles_->format.format == vulkanFormat(ColorFormat::rgba8) ? ColorFormat::rgba8
                                                                     : ColorFormat::bgra8;
}

std::vector<VkImageView> Presenter::views() const {
  std::vector<VkImageView> views;
  for (const auto& view : handles_->views) {
    views.push_back(*view);
  }
  return views;
}

void Presenter::waitForLast() {
  if (device_.handles().device.waitForFences(*handles_->drawn, VK_TRUE, kForever) !=
      vk::Result::eSuccess) {
    throw DeviceError(fmt::format("device {} did not finish a picture", device_.name()));
  }
  if (device_.pace()) {
    device_.pace()->endFrame();
  }
}

bool Presenter::prepare(PixelSize windowSize) {
  if (!isOutdated_ && windowSize == size_) {
    return true;
  }
  try {
    const auto capabilities =
        device_.handles().physical.getSurfaceCapabilitiesKHR(*handles_->surface);
    // Where the surface has no size of its own, it takes the swapchain's.
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    const vk::Extent2D own = capabilities.currentExtent;
    const PixelSize size = own.width == kNone ? windowSize : PixelSize{own.width, own.height};
    if (size.width == 0 || size.height == 0) {
      return false;
    }
    waitForLast();
    {
      const std::lock_guard lock(device_.queueMutex());
      device_.handles().queue.waitIdle();
    }
    handles_->createSwapchain(device_.handles().device, capabilities, size);
    size_ = size;
    isOutdated_ = false;
    ++generation_;
  } catch (const vk::SystemError& error) {
    fail(device_, error);
  }
  return true;
}

bool Presenter::present(const std::function<void(const CommandBuffer&, std::size_t)>& record) {
  try {
    waitForLast();
    const auto image = acquire();
    if (!image) {
      return false;
    }
    handles_->commands.reset();
    handles_->commands.begin(
        vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    record(handles_->commands, *image);
    handles_->commands.end();
    submit(*image);
    return show(*image);
  } catch (const vk::SystemError& error) {
    fail(device_, error);
  }
}

std::optional<std::uint32_t> Presenter::acquire() {
  try {
    const auto [result, image] =
        handles_->swapchain.acquireNextImage(kPatience, *handles_->acquired);
    isOutdated_ = result == vk::Result::eSuboptimalKHR;
    return result == vk::Result::eSuccess || isOutdated_ ? std::optional(image) : std::nullopt;
  } catch (const vk::OutOfDateKHRError&) {
    isOutdated_ = true;
    return std::nullopt;
  }
}

void Presenter::submit(std::uint32_t image) {
  const vk::PipelineStageFlags drawing = vk::PipelineStageFlagBits::eColorAttachmentOutput;
  device_.handles().device.resetFences(*handles_->drawn);
  if (device_.pace()) {
    device_.pace()->beginFrame();
  }
  const std::lock_guard lock(device_.queueMutex());
  device_.handles().queue.submit(
      vk::SubmitInfo(*handles_->acquired, drawing, *handles_->commands, *handles_->rendered[image]),
      *handles_->drawn);
}

bool Presenter::show(std::uint32_t image) {
  try {
    const std::lock_guard lock(device_.queueMutex());
    const auto result = device_.handles().queue.presentKHR(
        vk::PresentInfoKHR(*handles_->rendered[image], *handles_->swapchain, image));
    isOutdated_ |= result == vk::Result::eSuboptimalKHR;
  } catch (const vk::OutOfDateKHRError&) {
    isOutdated_ = true;
  }
  return !isOutdated_;
}

}  // namespace morphgrid
