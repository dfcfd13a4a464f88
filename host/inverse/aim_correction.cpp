#include "inverse/aim_correction.h"

#include <algorithm>
#include <utility>

#include "core/rigid_alignment.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

constexpr std::size_t kMixingDepth = 8;
// Of the whole correction.
constexpr double kLeastShare = 0.1;

VectorXd flattened(const Matrix3Xd& points) {
  return Eigen::Map<const VectorXd>(points.data(), points.size());
}

}  // namespace

AimCorrection::AimCorrection(const Matrix3Xd& targets, Matrix3Xd aim)
    : targets_(targets), aim_(std::move(aim)), mixing_(kMixingDepth) {}

const Matrix3Xd& AimCorrection::next(const Matrix3Xd& reached) {
  const Matrix3Xd missing = targets_ - alignRigidly(reached, targets_) * reached;
  const VectorXd points = mixing_.next(flattened(aim_), share_ * flattened(missing));
  trial_ = Eigen::Map<const Matrix3Xd>(points.data(), 3, aim_.cols());
  return trial_;
}

void AimCorrection::take() {
  aim_ = trial_;
  share_ = std::min(1.0, 2 * share_);
}

void AimCorrection::refuse() {
  mixing_.clear();
  share_ /= 2;
}

bool AimCorrection::isExhausted() const { return share_ < kLeastShare; }

}  // namespace morphgrid
