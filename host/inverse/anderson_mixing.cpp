#include "inverse/anderson_mixing.h"

#include <Eigen/QR>

namespace morphgrid {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd AndersonMixing::next(const VectorXd& at, const VectorXd& residual) {
  if (lastAt_.size() > 0 && depth_ > 0) {
    differences_.push_back({at - lastAt_, residual - lastResidual_});
    if (differences_.size() > depth_) {
      differences_.pop_front();
    }
  }
  lastAt_ = at;
  lastResidual_ = residual;
  VectorXd result = at + residual;
  if (!differences_.empty()) {
    MatrixXd changes(residual.size(), static_cast<Index>(differences_.size()));
    MatrixXd moves = changes;
    for (Index n = 0; n < changes.cols(); ++n) {
      changes.col(n) = differences_[n].residual;
      moves.col(n) = differences_[n].at;
    }
    const VectorXd shares = changes.colPivHouseholderQr().solve(residual);
    result -= (moves + changes) * shares;
  }
  return result;
}

void AndersonMixing::clear() {
  lastAt_.resize(0);
  differences_.clear();
}

}  // namespace morphgrid
