#include "solve/vertex_vector.h"

#include "shared/solver_types.h"
#include "solve/column_walk.h"

namespace morphgrid {

VertexVector::VertexVector(const Device& device, int vertexCount)
    : buffer_(device, static_cast<vk::DeviceSize>(vertexCount) * sizeof(vec4),
              vk::BufferUsageFlagBits::eStorageBuffer |
                  vk::BufferUsageFlagBits::eStorageTexelBuffer |
                  vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst,
              MemoryKind::device),
      texels_(floatTexels(device, buffer_)) {}

}  // namespace morphgrid
