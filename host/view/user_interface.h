#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "gpu/draw_pass.h"
#include "view/window.h"

namespace morphgrid {

/// Dear ImGui in a window, drawn over what is there. One at a time.
class UserInterface {
 public:
  /// format: of the swapchain. Keeps references. Throws InputError when there is no font,
  /// DeviceError when the device refuses.
  UserInterface(const Device& device, const Window& window, ColorFormat format);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// New images to draw over: of a swapchain of this size.
  void setImages(PixelSize size, const std::vector<VkImageView>& images);

  /// build() calls ImGui for the next record().
  void build(const std::function<void()>& build);

  /// Draws over image `image`, which is in eColorAttachmentOptimal and then in ePresentSrcKHR.
  void record(const CommandBuffer& commands, std::size_t image) const;

 private:
  struct Handles;

  void start(const Window& window);

  const Device& device_;
  std::unique_ptr<Handles> handles_;
  PixelSize size_;
};

}  // namespace morphgrid
