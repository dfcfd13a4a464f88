#pragma once
#include <Eigen/Core>

#include "gpu/buffer.h"

namespace morphgrid {

/// A vector of the solver in the device's memory: vec4 a vertex (x, y, z, 0), in units of the
/// spacing or, for gradients, of stiffness x spacing.
class VertexVector {
 public:
  /// Throws DeviceError when it exceeds the device's limits.
  VertexVector(const Device& device, int vertexCount);

  /// values: 3 x vertexCount. Both wait.
  void upload(const Device& device, const Eigen::Matrix3Xd& values) const;
  Eigen::Matrix3Xd download(const Device& device) const;

  const Buffer& buffer() const { return buffer_; }
  const TexelView& texels() const { return texels_; }

 private:
  Buffer buffer_;
  TexelView texels_;
};

/// Workgroups, of kVectorInvocations each, for a kernel that adds something up over so many
/// vertices, and leaves a sum per workgroup.
std::uint32_t reductionGroups(std::uint32_t vertexCount);

}  // namespace morphgrid
