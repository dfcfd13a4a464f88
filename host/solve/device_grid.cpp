#include "solve/device_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "energy/strut_energy.h"
#include "gpu/command_stream.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

constexpr int kFinestResolutionBits = 24;  // Floats hold differences of a spacing exactly.
// In steps of the resolution: what 32 bits hold, rounding included.
constexpr double kLargestCoordinate = std::numeric_limits<std::int32_t>::max() - 1;

const StrutGrid& validated(const StrutGrid& grid) {
  validate(grid);
  return grid;
}

/// The finest power of two whose 32-bit range holds the grid rolled out to either side of the
/// origin.
double chooseResolution(const GridShape& shape) {
  const double reach = shape.verticesU + shape.verticesV + shape.layers;
  const int rangeBits = static_cast<int>(std::ceil(std::log2(reach)));
  return std::ldexp(1.0, -std::min(kFinestResolutionBits, 31 - rangeBits));
}

/// Rest lengths on the way between the initial and the designed ones must fit too.
double chooseRestResolution(const StrutGrid& grid) {
  double longest = grid.spacing;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    longest = std::max({longest, valueAt(grid.rest, strut), lengthAt(grid.positions, strut)});
  });
  return std::ldexp(1.0, std::ilogb(longest / grid.spacing) + 1 - 31);
}

std::optional<UniformStiffness> findUniformStiffness(const StrutGrid& grid) {
  UniformStiffness uniform{0, 0};
  bool isUniform = true;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    float& common = strut.isLateral() ? uniform.lateral : uniform.vertical;
    const auto stiffness = static_cast<float>(valueAt(grid.stiffness, strut));
    common = common == 0 ? stiffness : common;
    isUniform = isUniform && common == stiffness;
  });
  return isUniform ? std::optional(uniform) : std::nullopt;
}

Buffer perVertexBuffer(const Device& device, const GridShape& shape) {
  using Usage = BufferUsage;
  return {device, shape.vertexCount() * sizeof(vec4),
          Usage::storageBuffer | Usage::uniformTexelBuffer | Usage::storageTexelBuffer |
              Usage::transferSrc | Usage::transferDst,
          MemoryKind::device};
}

/// One coordinate as a 32-bit integer and kExtraBits more bits.
struct FixedPoint {
  std::int32_t whole;
  std::int32_t extra;
};

FixedPoint toFixedPoint(double steps) {
  constexpr std::int64_t kExtraSteps = 1 << kExtraBits;
  const auto fine = static_cast<std::int64_t>(std::llround(steps * kExtraSteps));
  return {static_cast<std::int32_t>(fine >> kExtraBits),
          static_cast<std::int32_t>(fine & (kExtraSteps - 1))};
}

ivec4 encode(const Eigen::Vector3d& steps) {
  const FixedPoint x = toFixedPoint(steps.x());
  const FixedPoint y = toFixedPoint(steps.y());
  const FixedPoint z = toFixedPoint(steps.z());
  return {x.whole, y.whole, z.whole,
          x.extra | (y.extra << kExtraBits) | (z.extra << 2 * kExtraBits)};
}

Eigen::Vector3d decode(const ivec4& p) {
  constexpr int kMask = (1 << kExtraBits) - 1;
  constexpr double kExtraSteps = 1 << kExtraBits;
  const auto coordinate = [&](int axis) {
    return p[axis] + ((p.w >> (axis * kExtraBits)) & kMask) / kExtraSteps;
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

std::vector<vec4> packStiffness(const StrutValues& stiffness) {
  std::vector<vec4> packed(stiffness.u.size());
  for (std::size_t n = 0; n < packed.size(); ++n) {
    packed[n] = {stiffness.u[n], stiffness.v[n], stiffness.w[n], 0};
  }
  return packed;
}

}  // namespace

DeviceGrid::Storage::Storage(const Device& device, const GridShape& shape)
    : positions(perVertexBuffer(device, shape)),
      previousPositions(perVertexBuffer(device, shape)),
      rest(perVertexBuffer(device, shape)),
      stiffness(perVertexBuffer(device, shape)) {}

DeviceGrid::DeviceGrid(const Device& device, const StrutGrid& grid)
    : device_(device),
      shape_(validated(grid).shape),
      resolution_(chooseResolution(grid.shape)),
      storage_(std::make_shared<Storage>(device, shape_)) {
  take(grid);
}

void DeviceGrid::assign(const StrutGrid& grid) {
  assert(grid.shape == shape_);
  take(validated(grid));
}

void DeviceGrid::take(const StrutGrid& grid) {
  const StrutEnergy energy(grid);
  spacing_ = grid.spacing;
  weights_ = grid.weights;
  mostVertices_ = energy.mostVertices();
  restResolution_ = chooseRestResolution(grid);
  origin_ = grid.positions.rowwise().mean();
  uniformStiffness_ = findUniformStiffness(grid);
  storage_->stepsPerForce = (2 * energy.constraintWeights()).cwiseInverse();
  uploadPositions(grid.positions);
  uploadRest(grid.rest);
  upload(device_, storage_->stiffness, packStiffness(grid.stiffness));
}

std::shared_ptr<const DeviceGrid> DeviceGrid::onlooker() const {
  return std::shared_ptr<const DeviceGrid>(new DeviceGrid(*this));
}

void DeviceGrid::uploadPositions(const Eigen::Matrix3Xd& positions) {
  std::vector<ivec4> packed(positions.cols());
  for (Eigen::Index n = 0; n < positions.cols(); ++n) {
    const Eigen::Vector3d steps = (positions.col(n) - origin_) / (spacing_ * resolution_);
    if (!(steps.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
      throw InputError(fmt::format(
          "vertex {} lies {:.3g} spacings from the grid's middle, beyond the {:.3g} that "
          "the device's positions reach",
          n, steps.norm() * resolution_, kLargestCoordinate * resolution_));
    }
    packed[n] = encode(steps);
  }
  upload(device_, storage_->positions, packed);
  upload(device_, storage_->previousPositions, packed);
}

void DeviceGrid::uploadRest(const StrutValues& rest) {
  const auto toSteps = [&](double length) {
    return static_cast<std::int32_t>(std::llround(length / (spacing_ * restResolution_)));
  };
  std::vector<ivec4> packed(rest.u.size());
  for (std::size_t n = 0; n < packed.size(); ++n) {
    const auto stepPerForce =
        static_cast<float>(storage_->stepsPerForce[static_cast<Eigen::Index>(n)]);
    packed[n] = {toSteps(rest.u[n]), toSteps(rest.v[n]), toSteps(rest.w[n]),
                 std::bit_cast<std::int32_t>(stepPerForce)};
  }
  upload(device_, storage_->rest, packed);
}

Eigen::Matrix3Xd DeviceGrid::downloadPositions(const Buffer& from) const {
  const auto packed = download<ivec4>(device_, from, shape_.vertexCount());
  Eigen::Matrix3Xd positions(3, shape_.vertexCount());
  for (Eigen::Index n = 0; n < positions.cols(); ++n) {
    positions.col(n) = origin_ + spacing_ * resolution_ * decode(packed[n]);
  }
  return positions;
}

}  // namespace morphgrid
