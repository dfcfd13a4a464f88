#include "solve/lbfgs_vectors.h"

#include <algorithm>

#include "solve/lbfgs_combine_comp.h"
#include "solve/lbfgs_dots_comp.h"
#include "solve/lbfgs_pair_comp.h"
#include "solve/lbfgs_step_comp.h"

namespace morphgrid {
namespace {

std::vector<VertexVector> pairVectors(const Device& device, int length) {
  std::vector<VertexVector> vectors;
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    vectors.emplace_back(device, length);
    // Slots not yet in use have weight 0, and 0 times whatever memory holds may be no number.
    upload(device, vectors.back().buffer(), std::vector<vec4>(length, vec4(0)));
  }
  return vectors;
}

Buffer reductionBuffer(const Device& device, std::uint32_t count, std::size_t bytesPerGroup) {
  return {device, reductionGroups(count) * bytesPerGroup, BufferUsage::storageBuffer,
          MemoryKind::host};
}

Eigen::Vector3d vectorOf(const vec4& v) { return {v.x, v.y, v.z}; }

}  // namespace

LbfgsVectors::LbfgsVectors(const Device& device, const DeviceGrid& grid, Precision precision)
    : device_(device),
      count_(static_cast<std::uint32_t>(grid.vectorLength())),
      vertexCount_(static_cast<std::uint32_t>(grid.shape().vertexCount())),
      resolution_(static_cast<float>(grid.resolution())),
      gradient_(device, grid, precision, layerLoopFor(grid.shape())),
      rightSide_(device, grid.vectorLength()),
      correction_(device, grid.vectorLength()),
      direction_(device, grid.vectorLength()),
      steps_(pairVectors(device, grid.vectorLength())),
      changes_(pairVectors(device, grid.vectorLength())),
      largest_(reductionBuffer(device, count_, sizeof(float))),
      dots_(reductionBuffer(device, count_, sizeof(PairDots))),
      combining_(device, lbfgs_combine_comp_spirv, sizeof(CombinePush), {}),
      stepping_(device, lbfgs_step_comp_spirv, sizeof(StepPush), {}),
      pairing_(device, lbfgs_pair_comp_spirv, sizeof(StepPush), {}),
      dotting_(device, lbfgs_dots_comp_spirv, sizeof(DotsPush), {}),
      states_{state(grid.positions()), state(grid.previousPositions())},
      kernels_{stateKernels(states_[0], states_[1]), stateKernels(states_[1], states_[0])},
      combineDirection_([&] {
        std::vector<KernelResource> resources = texelsOf(kBindingSteps, steps_);
        resources.insert(resources.end(), {{kBindingBase, &correction_.texels()},
                                           {kBindingOutput, &direction_.buffer()},
                                           {kBindingReduced, &largest_}});
        return combining_.bind(resources);
      }()) {}

LbfgsVectors::State LbfgsVectors::state(const Buffer& positions) {
  VertexVector gradient(device_, static_cast<int>(count_));
  GridGradient::Evaluation evaluation = gradient_.evaluation(positions, gradient);
  return {&positions, integerTexels(device_, positions), std::move(gradient),
          std::move(evaluation)};
}

std::vector<KernelResource> LbfgsVectors::texelsOf(std::uint32_t binding,
                                                   const std::vector<VertexVector>& vectors) const {
  std::vector<KernelResource> resources;
  for (const VertexVector& vector : vectors) {
    resources.push_back({binding++, &vector.texels()});
  }
  return resources;
}

LbfgsVectors::StateKernels LbfgsVectors::stateKernels(const State& current, const State& trial) {
  // The combination's vectors are bound where the steps are, whatever they are.
  std::vector<KernelResource> rightSide = texelsOf(kBindingSteps, changes_);
  rightSide.insert(rightSide.end(), {{kBindingBase, &current.gradient.texels()},
                                     {kBindingOutput, &rightSide_.buffer()},
                                     {kBindingReduced, &largest_}});
  std::vector<KernelResource> dots = texelsOf(kBindingSteps, steps_);
  const std::vector<KernelResource> changes = texelsOf(kBindingChanges, changes_);
  dots.insert(dots.end(), changes.begin(), changes.end());
  dots.insert(dots.end(), {{kBindingGradient, &current.gradient.texels()},
                           {kBindingCorrection, &correction_.texels()},
                           {kBindingReduced, &dots_}});
  std::vector<ComputeKernel> pairs;
  for (std::uint32_t slot = 0; slot < kPairs; ++slot) {
    pairs.push_back(pairing_.bind({{kBindingFrom, &current.positionTexels},
                                   {kBindingTo, &trial.positionTexels},
                                   {kBindingBase, &current.gradient.texels()},
                                   {kBindingGradient, &trial.gradient.texels()},
                                   {kBindingOutput, &steps_[slot].buffer()},
                                   {kBindingOutput2, &changes_[slot].buffer()}}));
  }
  return {combining_.bind(rightSide),
          stepping_.bind({{kBindingFrom, &current.positionTexels},
                          {kBindingBase, &direction_.texels()},
                          {kBindingOutput, trial.positions}}),
          std::move(pairs), dotting_.bind(dots)};
}

void LbfgsVectors::recordCurrentGradient(CommandStream& stream) const {
  gradient_.record(stream, states_[current_].evaluation);
}

void LbfgsVectors::recordRightSide(CommandStream& stream,
                                   const PairHistory::Weights& weights) const {
  const std::uint32_t groups = reductionGroups(count_);
  stream.dispatch(
      kernels_[current_].rightSide,
      CombinePush{
          count_, groups * kVectorInvocations, vertexCount_, {weights[0], weights[1], weights[2]}},
      groups);
}

void LbfgsVectors::recordDirection(CommandStream& stream,
                                   const PairHistory::Weights& weights) const {
  const std::uint32_t groups = reductionGroups(count_);
  stream.dispatch(
      combineDirection_,
      CombinePush{
          count_, groups * kVectorInvocations, vertexCount_, {weights[0], weights[1], weights[2]}},
      groups);
}

void LbfgsVectors::recordTrial(CommandStream& stream, double length, int slot) const {
  const std::uint32_t groups = (count_ + kVectorInvocations - 1) / kVectorInvocations;
  const StepPush push{count_, static_cast<float>(length), resolution_, vertexCount_};
  stream.dispatch(kernels_[current_].step, push, groups);
  gradient_.record(stream, states_[1 - current_].evaluation);
  stream.dispatch(kernels_[current_].pair[slot], push, groups);
  recordDotsWith(stream, kernels_[1 - current_].dots);
}

void LbfgsVectors::recordDots(CommandStream& stream) const {
  recordDotsWith(stream, kernels_[current_].dots);
}

void LbfgsVectors::recordDotsWith(CommandStream& stream, const ComputeKernel& kernel) const {
  const std::uint32_t groups = reductionGroups(count_);
  stream.dispatch(kernel, DotsPush{count_, groups * kVectorInvocations}, groups);
}

double LbfgsVectors::largestStep() const {
  const auto groups = largest_.mapped<float>();
  return *std::max_element(groups.begin(), groups.end());
}

Dots LbfgsVectors::dots() const {
  Dots sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
  for (const PairDots& group : dots_.mapped<PairDots>()) {
    sum.gradient += vectorOf(group.gradient);
    sum.correction += vectorOf(group.correction);
    for (int i = 0; i < 3; ++i) {
      sum.products.row(i) += vectorOf(group.changes[i]).transpose();
    }
    sum.descent += group.gradient.w;
  }
  return sum;
}

}  // namespace morphgrid
