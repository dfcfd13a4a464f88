#include "solve/lbfgs.h"

#include <algorithm>

namespace morphgrid {

static_assert(kPairs == 3, "Dots holds three pairs");

int PairHistory::nextSlot() const {
  for (int slot = 0; slot < static_cast<int>(kPairs); ++slot) {
    if (std::find(slots_.begin(), slots_.end(), slot) == slots_.end()) {
      return slot;
    }
  }
  return slots_.front();
}

void PairHistory::add(const Eigen::Matrix3d& products) {
  const int slot = nextSlot();
  if (!slots_.empty() && slot == slots_.front()) {
    slots_.erase(slots_.begin());
  }
  if (products(slot, slot) > 0) {
    slots_.push_back(slot);
  }
}

PairHistory::Weights PairHistory::firstLoop(const Dots& dots) {
  Weights weights{};
  alpha_.setZero();
  for (auto slot = slots_.rbegin(); slot != slots_.rend(); ++slot) {
    const double along = dots.gradient[*slot] - dots.products.row(*slot).dot(alpha_);
    alpha_[*slot] = along / dots.products(*slot, *slot);
    weights[*slot] = static_cast<float>(-alpha_[*slot]);
  }
  return weights;
}

PairHistory::Weights PairHistory::secondLoop(const Dots& dots) const {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  for (const int slot : slots_) {
    const double along = dots.correction[slot] + dots.products.col(slot).dot(weights);
    weights[slot] = alpha_[slot] - along / dots.products(slot, slot);
  }
  return {float(weights[0]), float(weights[1]), float(weights[2])};
}

}  // namespace morphgrid
