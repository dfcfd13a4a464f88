#pragma once
#include <functional>

#include "gpu/device.h"

namespace morphgrid {

/// Shows pictures in a window: owns its surface and its swapchain, which follows the window's size.
class Presenter {
 public:
  /// Keeps a reference. Throws DeviceError when the device cannot draw into this window.
  Presenter(const Device& device, vk::raii::SurfaceKHR surface);
  /// Waits for what is being drawn.
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  vk::Format format() const { return format_.format; }
  vk::Extent2D size() const { return size_; }
  /// Of the swapchain's images; new ones whenever generation() has changed.
  std::vector<vk::ImageView> views() const;
  /// Counts the swapchains.
  int generation() const { return generation_; }

  /// Waits until the last picture has been drawn.
  void waitForLast();

  /// Makes a swapchain for a window of this size, in pixels, unless it is there. False when there
  /// is nothing to draw on: a window that is minimised.
  bool prepare(vk::Extent2D windowSize);

  /// Draws and shows a picture: record() gets the image's index in views(); it leaves the image in
  /// ePresentSrcKHR. False when the window has changed or has no room yet: prepare() and try again.
  /// Throws DeviceError when the device fails.
  bool present(const std::function<void(const vk::raii::CommandBuffer&, std::size_t)>& record);

 private:
  void createSwapchain(const vk::SurfaceCapabilitiesKHR& capabilities, vk::Extent2D size);
  std::optional<std::uint32_t> acquire();
  void submit(std::uint32_t image);
  bool show(std::uint32_t image);

  const Device& device_;
  vk::raii::SurfaceKHR surface_;
  vk::SurfaceFormatKHR format_;
  vk::raii::CommandPool pool_ = nullptr;
  vk::raii::CommandBuffer commands_ = nullptr;
  vk::raii::Fence drawn_ = nullptr;
  vk::raii::Semaphore acquired_ = nullptr;
  vk::raii::SwapchainKHR swapchain_ = nullptr;
  std::vector<vk::raii::ImageView> views_;
  std::vector<vk::raii::Semaphore> rendered_;  ///< One an image: its last showing may still wait.
  vk::Extent2D size_;
  int generation_ = 0;
  bool isOutdated_ = true;
};

}  // namespace morphgrid
