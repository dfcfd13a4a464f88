#pragma once
#include "gpu/buffer.h"

namespace morphgrid {

/// A vector of the solver in the device's memory: vec4 a vertex (x, y, z, 0), in units of the
/// spacing or, for gradients, of stiffness x spacing.
class VertexVector {
 public:
  /// Throws DeviceError when it exceeds the device's limits.
  VertexVector(const Device& device, int vertexCount);

  const Buffer& buffer() const { return buffer_; }
  const TexelView& texels() const { return texels_; }

 private:
  Buffer buffer_;
  TexelView texels_;
};

}  // namespace morphgrid
