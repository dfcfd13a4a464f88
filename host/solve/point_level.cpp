#include "solve/point_level.h"

#include "solve/coarse_matrix_comp.h"
#include "solve/invert_blocks_comp.h"
#include "solve/levers_comp.h"
#include "solve/matrix_first_smoothing_comp.h"
#include "solve/matrix_residual_comp.h"
#include "solve/matrix_smoothing_comp.h"
#include "solve/prolong_points_comp.h"
#include "solve/restrict_points_comp.h"

namespace morphgrid {
namespace {

constexpr auto kTexelUsage = BufferUsage::storageBuffer | BufferUsage::storageTexelBuffer |
                             BufferUsage::transferSrc | BufferUsage::transferDst;

/// The weight of Jacobi smoothing that damps eigenvalues from an eighth of the largest one on.
constexpr double smoothingWeightFor(double spectralRadius) {
  return 2 / (spectralRadius * (1 + 1.0 / 8));
}

TexelBuffer motions(const Device& device, PointGrid points) {
  return {device, 2 * static_cast<std::size_t>(points.count()), TexelFormat::float4,
          MemoryKind::device};
}

std::vector<BlockField> blockFields(const Device& device, PointGrid points, MemoryKind memory) {
  std::vector<BlockField> fields;
  for (std::uint32_t n = 0; n < kStencilSize; ++n) {
    fields.emplace_back(device, points.count(), memory);
  }
  return fields;
}

KernelFamily family(const Device& device, ShaderCode spirv, std::size_t pushBytes) {
  return {device, spirv, static_cast<std::uint32_t>(pushBytes), {device.subgroupSize()}};
}

}  // namespace

TexelBuffer::TexelBuffer(const Device& device, std::size_t texels, TexelFormat format,
                         MemoryKind kind)
    : buffer_(device, texels * sizeof(vec4), kTexelUsage, kind),
      texels_(device, buffer_, format, TexelAccess::image) {}

BlockField::BlockField(const Device& device, int pointCount, MemoryKind kind) {
  for (std::uint32_t n = 0; n < kBlockParts; ++n) {
    parts_.emplace_back(device, static_cast<std::size_t>(pointCount) * kPartTexels,
                        TexelFormat::float4, kind);
  }
}

void BlockField::appendTexels(std::vector<KernelResource>& resources, std::uint32_t binding) const {
  for (const TexelBuffer& part : parts_) {
    resources.push_back({binding++, &part.texels()});
  }
}

void BlockField::appendBuffers(std::vector<KernelResource>& resources,
                               std::uint32_t binding) const {
  for (const TexelBuffer& part : parts_) {
    resources.push_back({binding++, &part.buffer()});
  }
}

PointKernels::PointKernels(const Device& device)
    : inversion(family(device, invert_blocks_comp_spirv, sizeof(SmoothingPush))),
      firstSmoothing(family(device, matrix_first_smoothing_comp_spirv, sizeof(SmoothingPush))),
      residual(family(device, matrix_residual_comp_spirv, sizeof(SmoothingPush))),
      smoothing(family(device, matrix_smoothing_comp_spirv, sizeof(SmoothingPush))),
      levers(family(device, levers_comp_spirv, sizeof(TransferPush))),
      product(family(device, coarse_matrix_comp_spirv, sizeof(TransferPush))),
      restriction(family(device, restrict_points_comp_spirv, sizeof(TransferPush))),
      prolongation(family(device, prolong_points_comp_spirv, sizeof(TransferPush))) {}

PointLevel::PointLevel(const Device& device, PointKernels& kernels, PointGrid points,
                       MemoryKind memory, double spectralRadiusBound)
    : device_(device),
      points_(points),
      smoothingWeight_(smoothingWeightFor(spectralRadiusBound)),
      matrix_(blockFields(device, points, memory)),
      inverse_(device, points.count(), MemoryKind::device),
      centres_(device, static_cast<std::size_t>(points.count()), TexelFormat::int4, memory),
      rightSide_(motions(device, points)),
      iterate_(motions(device, points)),
      result_(motions(device, points)),
      inversion_(inversionKernel(kernels)),
      firstSmoothing_(firstSmoothingKernel(kernels)),
      residual_(residualKernel(kernels)),
      smoothing_(smoothingKernel(kernels)) {}

std::vector<KernelResource> PointLevel::matrixTexels() const {
  std::vector<KernelResource> resources;
  for (std::uint32_t n = 0; n < kStencilSize; ++n) {
    matrix_[n].appendTexels(resources, kBindingMatrix + n * kBlockParts);
  }
  return resources;
}

std::vector<KernelResource> PointLevel::matrixBuffers() const {
  std::vector<KernelResource> resources;
  for (std::uint32_t n = 0; n < kStencilSize; ++n) {
    matrix_[n].appendBuffers(resources, kBindingCoarseMatrix + n * kBlockParts);
  }
  return resources;
}

PointKernel PointLevel::inversionKernel(PointKernels& kernels) const {
  std::vector<KernelResource> resources;
  matrix_[kStencilSelf].appendTexels(resources, kBindingMatrix);
  inverse_.appendBuffers(resources, kBindingInverse);
  return {device_, kernels.inversion, points_, resources};
}

PointKernel PointLevel::firstSmoothingKernel(PointKernels& kernels) const {
  std::vector<KernelResource> resources{{kBindingRightSide, &rightSide_.texels()},
                                        {kBindingResult, &iterate_.buffer()}};
  inverse_.appendTexels(resources, kBindingInverse);
  return {device_, kernels.firstSmoothing, points_, resources};
}

PointKernel PointLevel::residualKernel(PointKernels& kernels) const {
  std::vector<KernelResource> resources = matrixTexels();
  resources.insert(resources.end(), {{kBindingIterate, &iterate_.texels()},
                                     {kBindingRightSide, &rightSide_.texels()},
                                     {kBindingResult, &result_.buffer()}});
  return {device_, kernels.residual, points_, resources};
}

PointKernel PointLevel::smoothingKernel(PointKernels& kernels) const {
  std::vector<KernelResource> resources = matrixTexels();
  resources.insert(resources.end(), {{kBindingIterate, &iterate_.texels()},
                                     {kBindingRightSide, &rightSide_.texels()},
                                     {kBindingResult, &result_.buffer()}});
  inverse_.appendTexels(resources, kBindingInverse);
  return {device_, kernels.smoothing, points_, resources};
}

SmoothingPush PointLevel::push() const {
  return {sizeOf(points_), static_cast<float>(smoothingWeight_), 0};
}

void PointLevel::recordInversion(CommandStream& stream) const { inversion_.record(stream, push()); }

void PointLevel::recordFirstSmoothing(CommandStream& stream) const {
  firstSmoothing_.record(stream, push());
}

void PointLevel::recordResidual(CommandStream& stream) const { residual_.record(stream, push()); }

void PointLevel::recordSmoothing(CommandStream& stream) const { smoothing_.record(stream, push()); }

}  // namespace morphgrid
