#pragma once
#include "gpu/graphics_pipeline.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/sampling_layout.h"
#include "shared/render_types.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// How rays sampled a mesh, on white: the mesh in grey, the Catmull-Rom splines through the hits
/// along u in red and along v in blue, the hits where drawn splines cross as dark balls. Of many
/// rays every n-th isoline is drawn, up to about 40 each way, and the last one. Missed rays
/// interrupt the splines and are marked in orange, at the middle depth of the hits, in front of
/// everything; of many rays one mark stands for neighbours.
class SamplingDrawing {
 public:
  /// For passes like this one. Throws DeviceError when the mesh exceeds the device's limits.
  SamplingDrawing(const Device& device, const TriangleMesh& mesh, const RayHits& hits,
                  const DrawPass& pass);

  /// Records the draws; inside the pass. imageHeight in pixels.
  void draw(const CommandBuffer& commands, const Camera& camera, int imageHeight) const;

 private:
  /// Things that are drawn by one pair of shaders, from the same buffers.
  struct Layer {
    Layer(const Device& device, const ShaderPair& shaders,
          const std::vector<KernelResource>& buffers, const DrawPass& pass);
    void draw(const CommandBuffer& commands, const SamplingPush& push,
              Eigen::Index vertexCount) const;

    GraphicsPipeline pipeline;
    ResourceSet resources;
  };

  SamplingLayout layout_;
  Eigen::Index meshVertices_;  ///< To draw.
  int raysU_;
  int raysV_;
  Buffer vertices_;
  Buffer triangles_;
  Buffer rays_;
  Buffer balls_;
  Layer mesh_;
  Layer splines_;
  Layer ballLayer_;
};

/// Off screen. width, height > 0 in pixels; samples of a pixel, where the device has them: 1 or 4.
/// Throws DeviceError when the device fails or the mesh exceeds its limits.
Image drawSampling(const Device& device, const TriangleMesh& mesh, const RayHits& hits,
                   const Camera& camera, int width, int height, int samples = 4);

}  // namespace morphgrid
