#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/draw_pass.h"

namespace morphgrid {

/// Shows pictures in a window: owns its surface and its swapchain, which follows the window's size.
class Presenter {
 public:
  /// surface: of the device's instance, owned from here on. Keeps a reference. Throws DeviceError
  /// when the device cannot draw into this window.
  Presenter(const Device& device, VkSurfaceKHR surface);
  /// Waits for what is being drawn.
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  ColorFormat format() const;
  PixelSize size() const { return size_; }
  /// Views of the swapchain's images; new ones whenever generation() has changed.
  std::vector<VkImageView> views() const;
  /// Counts the swapchains.
  int generation() const { return generation_; }

  /// Waits until the last picture has been drawn.
  void waitForLast();

  /// Makes a swapchain for a window of this size unless it is there. False when there is nothing to
  /// draw on: a window that is minimised.
  bool prepare(PixelSize windowSize);

  /// Draws and shows a picture: record() gets the image's index in views(); it leaves the image in
  /// ePresentSrcKHR. False when the window has changed or has no room yet: prepare() and try again.
  /// Throws DeviceError when the device fails.
  bool present(const std::function<void(const CommandBuffer&, std::size_t)>& record);

 private:
  struct Handles;

  std::optional<std::uint32_t> acquire();
  void submit(std::uint32_t image);
  bool show(std::uint32_t image);

  const Device& device_;
  std::unique_ptr<Handles> handles_;
  PixelSize size_;
  int generation_ = 0;
  bool isOutdated_ = true;
};

}  // namespace morphgrid
