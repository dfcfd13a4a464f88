#include "solve/device_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "energy/joint_term.h"
#include "energy/strut_energy.h"
#include "gpu/command_stream.h"
#include "shared/solver_types.h"

namespace morphgrid {
namespace {

constexpr int kVerticesOfBar = 2;
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

Buffer texelBuffer(const Device& device, std::uint64_t count) {
  using Usage = BufferUsage;
  return {device, count * sizeof(vec4),
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

constexpr double kRotationSteps = std::uint64_t{1} << kRotationBits;

ivec4 encodeRotation(const Eigen::Vector4d& rotation) {
  const auto component = [&](int n) {
    return static_cast<std::int32_t>(std::llround(rotation[n] * kRotationSteps));
  };
  return {component(0), component(1), component(2), component(3)};
}

Eigen::Vector4d decodeRotation(const ivec4& rotation) {
  return Eigen::Vector4d(rotation.x, rotation.y, rotation.z, rotation.w).normalized();
}

DeviceBarSection onDevice(const BarSection& section, double spacing) {
  const double cubed = spacing * spacing * spacing;
  return {
      static_cast<float>(section.stretching / spacing),
      static_cast<float>(section.bendingN / cubed), static_cast<float>(section.bendingB / cubed),
      static_cast<float>(section.twisting / cubed), static_cast<float>(section.shearing * spacing)};
}

std::optional<DeviceFrame> frameOf(const StrutGrid& grid) {
  if (!grid.bars) {
    return std::nullopt;
  }
  const BarSection& lateral = grid.bars->lateral;
  const BarSection& upright = grid.bars->upright;
  DeviceFrame frame{onDevice(lateral, grid.spacing), onDevice(upright, grid.spacing),
                    static_cast<float>(lateral.joint / grid.spacing),
                    static_cast<float>(upright.joint / grid.spacing)};
  if (grid.bars->loads) {
    const Eigen::Vector3d holding = JointTerm::holdingOf(grid);
    frame.holding = static_cast<float>(holding.z());
    frame.holdingAside = static_cast<float>(holding.x());
    frame.turning = static_cast<float>(JointTerm::turningOf(grid) / (grid.spacing * grid.spacing));
  }
  return frame;
}

/// See kBindingLoads.
std::vector<vec4> packLoads(const JointLoads& loads, double spacing) {
  std::vector<vec4> packed;
  packed.reserve(static_cast<std::size_t>(loads.forces.cols()));
  for (const auto& force : loads.forces.colwise()) {
    packed.emplace_back(force.x() / spacing, force.y() / spacing, force.z() / spacing, 0);
  }
  for (const int joint : loads.held) {
    packed[joint].w = 1;
  }
  return packed;
}

/// See kBindingPrinted.
std::vector<vec4> packDirections(const GridShape& shape, const Eigen::Matrix3Xd& printed) {
  std::vector<vec4> packed(shape.vertexCount(), vec4(1, 0, 0, 1));
  forEachLateralStrut(shape, [&](const Strut& strut) {
    const Eigen::Vector3d along = (printed.col(strut.to) - printed.col(strut.from)).normalized();
    const int first = strut.direction == Strut::Direction::u ? 0 : 2;
    packed[strut.from][first] = static_cast<float>(along.x());
    packed[strut.from][first + 1] = static_cast<float>(along.y());
  });
  return packed;
}

std::vector<vec4> packStiffness(const StrutValues& stiffness) {
  std::vector<vec4> packed(stiffness.u.size());
  for (std::size_t n = 0; n < packed.size(); ++n) {
    packed[n] = {stiffness.u[n], stiffness.v[n], stiffness.w[n], 0};
  }
  return packed;
}

}  // namespace

DeviceGrid::Storage::Storage(const Device& device, const GridShape& shape, Mechanics mechanics)
    : positions(texelBuffer(
          device, (mechanics == Mechanics::frame ? 2 : 1) * std::uint64_t(shape.vertexCount()))),
      previousPositions(texelBuffer(device, positions.bytes() / sizeof(ivec4))),
      rest(texelBuffer(device, shape.vertexCount())),
      stiffness(texelBuffer(device, shape.vertexCount())),
      printed(texelBuffer(device, mechanics == Mechanics::springs ? 1 : shape.vertexCount())) {}

DeviceGrid::DeviceGrid(const Device& device, const StrutGrid& grid)
    : device_(device),
      shape_(validated(grid).shape),
      resolution_(chooseResolution(grid.shape)),
      mechanics_(mechanicsOf(grid)),
      storage_(std::make_shared<Storage>(device, shape_, mechanics_)) {
  take(grid);
}

void DeviceGrid::assign(const StrutGrid& grid) {
  assert(grid.shape == shape_ && mechanicsOf(grid) == mechanics_);
  take(validated(grid));
}

void DeviceGrid::take(const StrutGrid& grid) {
  const StrutEnergy energy(grid);
  spacing_ = grid.spacing;
  weights_ = grid.weights;
  mostVertices_ = grid.bars ? kVerticesOfBar : energy.mostVertices();
  restResolution_ = chooseRestResolution(grid);
  origin_ = grid.positions.rowwise().mean();
  uniformStiffness_ = findUniformStiffness(grid);
  storage_->stepsPerForce = (2 * energy.constraintWeights()).cwiseInverse();
  frame_ = frameOf(grid);
  isLoaded_ = frame_ && grid.bars->loads;
  freeMotions_ = morphgrid::freeMotions(grid);
  if (frame_) {
    takeBars(grid);
  } else if (grid.printedCorners) {
    upload(device_, storage_->printed, packDirections(shape_, *grid.printedCorners));
  }
  uploadPositions(grid.positions);
  uploadRest(grid.rest);
  upload(device_, storage_->stiffness, packStiffness(grid.stiffness));
}

void DeviceGrid::takeBars(const StrutGrid& grid) {
  upload(device_, storage_->printed, packDirections(shape_, grid.bars->printed));
  if (isLoaded_) {
    if (!storage_->loads) {
      storage_->loads.emplace(texelBuffer(device_, shape_.vertexCount()));
      storage_->printedPositions.emplace(texelBuffer(device_, shape_.vertexCount()));
    }
    upload(device_, *storage_->loads, packLoads(*grid.bars->loads, spacing_));
    upload(device_, *storage_->printedPositions, packed(grid.bars->printed));
  }
}

std::shared_ptr<const DeviceGrid> DeviceGrid::onlooker() const {
  return std::shared_ptr<const DeviceGrid>(new DeviceGrid(*this));
}

std::vector<ivec4> DeviceGrid::packed(const Eigen::Matrix3Xd& positions) const {
  std::vector<ivec4> packed(static_cast<std::size_t>(positions.cols()));
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
  return packed;
}

void DeviceGrid::uploadPositions(const Eigen::Matrix3Xd& positions,
                                 const JointRotations& rotations) {
  const ivec4 unturned(0, 0, 0, std::int32_t{1} << kRotationBits);
  std::vector<ivec4> packed = this->packed(positions);
  packed.resize(vectorLength(), unturned);
  for (Eigen::Index n = 0; n < rotations.cols(); ++n) {
    packed[positions.cols() + n] = encodeRotation(rotations.col(n));
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

JointRotations DeviceGrid::downloadRotations(const Buffer& from) const {
  if (!isFrame()) {
    return {};
  }
  const auto packed = download<ivec4>(device_, from, vectorLength());
  JointRotations rotations(4, shape_.vertexCount());
  for (Eigen::Index n = 0; n < rotations.cols(); ++n) {
    rotations.col(n) = decodeRotation(packed[rotations.cols() + n]);
  }
  return rotations;
}

}  // namespace morphgrid
