#include <cmath>

#include "core/decimals.h"
#include "propose/candidate.h"
#include "propose/choose_design.h"
#include "surface/box_text.h"

namespace morphgrid {
namespace {

constexpr double kSize = 100;  // mm

/// As a mesh configuration's steps do it, one after the other.
Eigen::Affine3d asStep(const Eigen::Matrix3d& linear, const Eigen::Vector3d& translation) {
  Eigen::Affine3d step = Eigen::Affine3d::Identity();
  step.linear() = linear;
  step.translation() = translation;
  return step;
}

/// The middle of what rays met in the box, to a thousandth of the box.
Eigen::Vector3d middleOf(const Candidate& candidate) {
  const SamplingBox& box = *candidate.surface.box;
  const auto& x = candidate.target->meshSampling()->hits.points.row(0);
  const int decimals = decimalsFor(1e-3 * std::max(box.uLength, box.vLength));
  const auto place = [&](double value) { return roundedTo(value, decimals); };
  return {place((x.minCoeff() + x.maxCoeff()) / 2), place(box.uStart + box.uLength / 2),
          place(box.vStart + box.vLength / 2)};
}

}  // namespace

Eigen::Affine3d Placement::worldFromMesh() const {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return asStep(scale * identity, zero) *
         (asStep(identity, -center) * asStep(sight.rotation(), zero));
}

SceneProposal settle(const Candidate& candidate, const ProposalRequest& request) {
  SceneProposal proposal{.request = request,
                         .surface = candidate.surface,
                         .design = candidate.design,
                         .material = chooseMaterial(request),
                         .share = candidate.share,
                         .slope = candidate.slope,
                         .seen = *candidate.surface.box,
                         .trial = candidate.trial};
  const SamplingBox& box = proposal.seen;
  Placement& placement = proposal.placement;
  placement = {
      candidate.rating.sight, middleOf(candidate),
      roundedToDigits(request.size.value_or(kSize) / std::max(box.uLength, box.vLength), 4)};
  const double scale = placement.scale;
  proposal.surface.configuration.worldFromMesh = placement.worldFromMesh();
  proposal.surface.box = roundedBox({scale * (box.uStart - placement.center.y()),
                                     scale * (box.vStart - placement.center.z()),
                                     scale * box.uLength, scale * box.vLength});
  proposal.surface.fillHoles = roundedToDigits(scale * candidate.surface.fillHoles, 2);
  proposal.design.layerSpacing = roundedToDigits(scale * candidate.design.layerSpacing, 3);
  return proposal;
}

}  // namespace morphgrid
