#pragma once
#include <functional>

#include "gpu/device.h"
#include "view/window.h"

namespace morphgrid {

/// Dear ImGui in a window, drawn over what is there. One at a time.
class UserInterface {
 public:
  /// format: of the swapchain. Keeps references. Throws InputError when there is no font,
  /// DeviceError when the device refuses.
  UserInterface(const Device& device, const Window& window, vk::Format format);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// New images to draw over: of a swapchain of this size.
  void setImages(vk::Extent2D size, const std::vector<vk::ImageView>& images);

  /// build() calls ImGui for the next record().
  void build(const std::function<void()>& build);

  /// Draws over image `image`, which is in eColorAttachmentOptimal and then in ePresentSrcKHR.
  void record(const vk::raii::CommandBuffer& commands, std::size_t image) const;

 private:
  void start(const Window& window);

  const Device& device_;
  vk::raii::DescriptorPool pool_;
  vk::raii::RenderPass renderPass_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
  vk::Extent2D size_;
};

}  // namespace morphgrid
