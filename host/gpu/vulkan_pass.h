#pragma once
#include "gpu/draw_pass.h"
#include "gpu/vulkan_attachment.h"

namespace morphgrid {

vk::Format vulkanFormat(ColorFormat format);

struct DrawPass::Handles {
  vk::Format format;
  vk::Format depthFormat;
  vk::SampleCountFlagBits samples;
  vk::raii::RenderPass renderPass;
};

}  // namespace morphgrid
