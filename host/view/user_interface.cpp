#include "view/user_interface.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <fmt/format.h>
#include <imgui.h>

#include "core/error.h"
#include "gpu/command_stream.h"
#include "gpu/vulkan_commands.h"
#include "gpu/vulkan_pass.h"
#include "render/font.h"

namespace morphgrid {
namespace {

constexpr std::uint32_t kFramesInFlight = 2;  // The least that the backend takes.
constexpr float kTextSize = 15;               // Pixels.
constexpr float kTableSize = 12;

vk::raii::DescriptorPool fontPool(const Device& device) {
  const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, 1);
  return {
      device.handles().device,
      vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size)};
}

/// Keeps what is there and hands the image to the screen.
vk::raii::RenderPass overlayPass(const Device& device, ColorFormat format) {
  using Stage = vk::PipelineStageFlagBits;
  using Access = vk::AccessFlagBits;
  const vk::AttachmentDescription attachment(
      {}, vulkanFormat(format), vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
      vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
      vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eColorAttachmentOptimal,
      vk::ImageLayout::ePresentSrcKHR);
  const vk::AttachmentReference color(0, vk::ImageLayout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, 0, nullptr, 1, &color);
  const vk::SubpassDependency before(VK_SUBPASS_EXTERNAL, 0, Stage::eColorAttachmentOutput,
                                     Stage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                                     Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
  return {device.handles().device, vk::RenderPassCreateInfo({}, attachment, subpass, before)};
}

void check(VkResult result) {
  if (result < 0) {
    throw DeviceError(fmt::format("the device cannot draw the panels: {}",
                                  vk::to_string(static_cast<vk::Result>(result))));
  }
}

void setStyle() {
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.FramePadding = {6, 3};
  style.FrameBorderSize = 1;
}

void loadFont() {
  ImFontConfig config;
  config.OversampleH = 1;  // Whole pixels: sharper at this size.
  static const ImWchar kLetters[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2044, 0x2190,
                                     0x21FF, 0x2212, 0x2212, 0x2264, 0x2265, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.AddFontFromFileTTF(Font::sansFile().c_str(), kTextSize, &config, kLetters);
  // The last font is for tables.
  fonts.AddFontFromFileTTF(Font::monoFile().c_str(), kTableSize, &config, kLetters);
}

void uploadFont(const Device& device) {
  CommandStream stream(device);
  stream.begin();
  ImGui_ImplVulkan_CreateFontsTexture(*stream.commands());
  stream.end();
  stream.submitAndWait();
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

}  // namespace

struct UserInterface::Handles {
  vk::raii::DescriptorPool pool;
  vk::raii::RenderPass renderPass;
  std::vector<vk::raii::Framebuffer> framebuffers;
};

UserInterface::UserInterface(const Device& device, const Window& window, ColorFormat format)
    : device_(device),
      handles_(
          std::make_unique<Handles>(Handles{fontPool(device), overlayPass(device, format), {}})) {
  ImGui::CreateContext();
  try {
    start(window);
  } catch (...) {
    ImGui::DestroyContext();
    throw;
  }
}

void UserInterface::start(const Window& window) {
  ImGui::GetIO().IniFilename = nullptr;  // No files where the user happens to be.
  setStyle();
  loadFont();
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo info{};
  const DeviceHandles& device = device_.handles();
  info.Instance = *device.instance;
  info.PhysicalDevice = *device.physical;
  info.Device = *device.device;
  info.QueueFamily = device.queueFamily;
  info.Queue = *device.queue;
  info.DescriptorPool = *handles_->pool;
  info.MinImageCount = kFramesInFlight;
  info.ImageCount = kFramesInFlight;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check;
  ImGui_ImplVulkan_Init(&info, *handles_->renderPass);
  uploadFont(device_);
}

UserInterface::~UserInterface() {
  {
    // What still draws uses the backend's buffers. Vulkan's own function: it does not throw.
    const std::lock_guard lock(device_.queueMutex());
    device_.handles().device.getDispatcher()->vkDeviceWaitIdle(*device_.handles().device);
  }
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void UserInterface::setImages(PixelSize size, const std::vector<VkImageView>& images) {
  size_ = size;
  handles_->framebuffers.clear();
  for (const vk::ImageView image : images) {
    handles_->framebuffers.emplace_back(
        device_.handles().device,
        vk::FramebufferCreateInfo({}, *handles_->renderPass, image, size.width, size.height, 1));
  }
}

void UserInterface::build(const std::function<void()>& build) {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  build();
  ImGui::Render();
}

void UserInterface::record(const CommandBuffer& commands, std::size_t image) const {
  commands.beginRenderPass(
      vk::RenderPassBeginInfo(*handles_->renderPass, *handles_->framebuffers.at(image),
                              {{0, 0}, {size_.width, size_.height}}),
      vk::SubpassContents::eInline);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
  commands.endRenderPass();
}

}  // namespace morphgrid
