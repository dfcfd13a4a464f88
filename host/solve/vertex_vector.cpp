#include "solve/vertex_vector.h"

#include <algorithm>

#include "gpu/command_stream.h"
#include "shared/lbfgs_types.h"
#include "shared/solver_types.h"
#include "solve/column_walk.h"

namespace morphgrid {

VertexVector::VertexVector(const Device& device, int vertexCount)
    : buffer_(device, static_cast<std::uint64_t>(vertexCount) * sizeof(vec4),
              BufferUsage::storageBuffer | BufferUsage::storageTexelBuffer |
                  BufferUsage::transferSrc | BufferUsage::transferDst,
              MemoryKind::device),
      texels_(floatTexels(device, buffer_)) {}

void VertexVector::upload(const Device& device, const Eigen::Matrix3Xd& values) const {
  std::vector<vec4> packed;
  packed.reserve(static_cast<std::size_t>(values.cols()));
  for (const auto& value : values.colwise()) {
    packed.emplace_back(value.x(), value.y(), value.z(), 0);
  }
  morphgrid::upload(device, buffer_, packed);
}

Eigen::Matrix3Xd VertexVector::download(const Device& device) const {
  const auto packed = morphgrid::download<vec4>(device, buffer_, buffer_.bytes() / sizeof(vec4));
  Eigen::Matrix3Xd values(3, static_cast<Eigen::Index>(packed.size()));
  for (Eigen::Index n = 0; n < values.cols(); ++n) {
    const vec4& value = packed[static_cast<std::size_t>(n)];
    values.col(n) << value.x, value.y, value.z;
  }
  return values;
}

std::uint32_t reductionGroups(std::uint32_t vertexCount) {
  // Few: what a workgroup costs when it adds up is worth many vertices.
  constexpr std::uint32_t kVerticesPerGroup = 16 * kVectorInvocations;
  return std::min((vertexCount + kVerticesPerGroup - 1) / kVerticesPerGroup, kMostReductionGroups);
}

}  // namespace morphgrid
