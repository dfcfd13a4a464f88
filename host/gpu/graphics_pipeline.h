#pragma once
#include "gpu/draw_pass.h"
#include "gpu/resource_set.h"
#include "gpu/shader_code.h"

namespace morphgrid {

struct ShaderPair {
  ShaderCode vertex;
  ShaderCode fragment;
  std::vector<std::uint32_t> constants = {};  ///< Values of constant_id 0, 1, ... of both.
};

enum class Blending {
  opaque,
  translucent,  ///< Blended by alpha over what is there; hides nothing that is drawn later.
};

enum class Primitive {
  triangles,
  frontTriangles,  ///< Those that are counter-clockwise in the picture: closed bodies need no more.
  lines,
};

/// Draws triangles or lines of a pixel's width, with a depth test. There are no
/// vertex attributes: the vertex shader makes everything from gl_VertexIndex and its resources.
/// Push constants reach both shaders.
class GraphicsPipeline {
 public:
  /// slots: what the vertex shader reads. Throws DeviceError when the device refuses.
  GraphicsPipeline(const Device& device, const ShaderPair& shaders,
                   const std::vector<ResourceSlot>& slots, std::uint32_t pushConstantBytes,
                   const DrawPass& pass, Blending blending = Blending::opaque,
                   Primitive primitive = Primitive::triangles);
  GraphicsPipeline(GraphicsPipeline&&) = default;
  GraphicsPipeline& operator=(GraphicsPipeline&&) = default;

  const ResourceLayout& resourceLayout() const { return resourceLayout_; }

  /// Records what draw() needs; inside the pass.
  void bind(const CommandBuffer& commands, const ResourceSet& resources) const;

  template <typename Push>
  void draw(const CommandBuffer& commands, const Push& push, std::uint32_t vertexCount) const {
    drawBytes(commands, &push, sizeof(Push), vertexCount);
  }

 private:
  struct Handles;

  void drawBytes(const CommandBuffer& commands, const void* push, std::uint32_t pushBytes,
                 std::uint32_t vertexCount) const;

  ResourceLayout resourceLayout_;
  std::shared_ptr<const Handles> handles_;
};

}  // namespace morphgrid
