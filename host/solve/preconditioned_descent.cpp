#include "solve/preconditioned_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphgrid {
namespace {

constexpr double kLargestMove = 2;  // Spacings, of any vertex in one step.
constexpr double kSufficientDecrease = 1e-4;
constexpr int kLineSearchSteps = 12;
// The Hessian is taken anew when the energy falls by less than this share of what it predicts, but
// neither at once again nor after too long.
constexpr double kModelFailure = 0.25;
constexpr int kFewestStepsPerLinearisation = 3;
constexpr int kMostStepsPerLinearisation = 20;
// Damping, where no step goes downhill: raised from the first to the last value, lowered again at
// every new Hessian.
constexpr double kFirstDamping = 1e-3;
constexpr double kLargestDamping = 10;
constexpr double kDampingGrowth = 10;
constexpr double kDampingDecay = 0.3;

}  // namespace

PreconditionedDescent::PreconditionedDescent(const Device& device, DeviceGrid& grid,
                                             Precision precision)
    : grid_(grid),
      energyRounding_(precision == Precision::precise ? 1e-12 : 1e-7),
      vectors_(device, grid, precision),
      cycle_(device, grid, vectors_.rightSide(), vectors_.correction()),
      stream_(device),
      predictedDecrease_(std::numeric_limits<double>::infinity()) {
  begin(false);
}

void PreconditionedDescent::begin(bool keepsHessian) {
  history_.clear();
  predictedDecrease_ = std::numeric_limits<double>::infinity();
  damping_ = 0;
  linearisationIsStale_ = linearisationIsStale_ || !keepsHessian;
  linearisationIsHere_ = false;
  stream_.begin();
  vectors_.recordCurrentGradient(stream_);
  stream_.end();
  stream_.submitAndWait();
  sums_ = vectors_.sums();
}

void PreconditionedDescent::takeHessian() {
  damping_ = 0;
  linearise();
}

double PreconditionedDescent::gradientNorm() const { return std::sqrt(sums_.squaredNorm); }

void PreconditionedDescent::linearise() {
  cycle_.linearise(vectors_.currentPositions(), damping_);
  linearisationIsStale_ = false;
  linearisationIsHere_ = true;
  stepsSinceLinearisation_ = 0;
  damping_ = damping_ > kFirstDamping ? damping_ * kDampingDecay : 0;
}

bool PreconditionedDescent::iterate() {
  if (linearisationIsStale_) {
    linearise();
  }
  double damping = kFirstDamping;
  while (!descend()) {
    // Off to a new start: first without what the pairs and an older Hessian remember, then more and
    // more cautiously.
    if (history_.empty() && linearisationIsHere_) {
      if (damping > kLargestDamping) {
        return false;
      }
      damping_ = damping;
      damping *= kDampingGrowth;
    }
    history_.clear();
    linearise();
  }
  return true;
}

bool PreconditionedDescent::descend() {
  stream_.begin();
  vectors_.recordRightSide(stream_, history_.firstLoop(dots_));
  cycle_.record(stream_);
  vectors_.recordDots(stream_);
  stream_.end();
  stream_.submitAndWait();
  dots_ = vectors_.dots();

  const PairHistory::Weights weights = history_.secondLoop(dots_);
  double descent = dots_.descent;
  for (std::size_t slot = 0; slot < weights.size(); ++slot) {
    descent += weights[slot] * dots_.gradient[static_cast<Eigen::Index>(slot)];
  }
  if (!(descent > 0)) {
    return false;
  }
  if (damping_ == 0) {
    predictedDecrease_ = descent / 2;
  }
  tryFullStep(weights);
  return searchLine(descent);
}

void PreconditionedDescent::tryFullStep(const PairHistory::Weights& weights) {
  stream_.begin();
  vectors_.recordDirection(stream_, weights);
  vectors_.recordTrial(stream_, 1, history_.nextSlot());
  stream_.end();
  stream_.submitAndWait();
}

void PreconditionedDescent::tryStep(double length) {
  stream_.begin();
  vectors_.recordTrial(stream_, length, history_.nextSlot());
  stream_.end();
  stream_.submitAndWait();
}

bool PreconditionedDescent::searchLine(double descent) {
  double length = std::min(1.0, kLargestMove / vectors_.largestStep());
  for (int attempt = 0; attempt < kLineSearchSteps; ++attempt, length /= 2) {
    if (length < 1) {
      tryStep(length);
    }
    const GridGradient::Sums trial = vectors_.sums();
    const double allowed = sums_.energy - kSufficientDecrease * length * descent +
                           energyRounding_ * std::abs(sums_.energy);
    if (trial.energy <= allowed) {
      predictedDecrease_ = descent / 2;
      linearisationIsStale_ = modelFails(sums_.energy - trial.energy);
      ++stepsSinceLinearisation_;
      sums_ = trial;
      dots_ = vectors_.dots();
      history_.add(dots_.products);
      linearisationIsHere_ = false;
      vectors_.accept();
      grid_.noteNewest(vectors_.currentIsFirst());
      return true;
    }
  }
  return false;
}

bool PreconditionedDescent::modelFails(double decrease) const {
  const int steps = stepsSinceLinearisation_ + 1;
  return steps >= kMostStepsPerLinearisation || (steps >= kFewestStepsPerLinearisation &&
                                                 decrease < kModelFailure * 2 * predictedDecrease_);
}

void PreconditionedDescent::finish() {
  if (!vectors_.currentIsFirst()) {
    stream_.begin();
    stream_.copy(grid_.previousPositions(), grid_.positions(), grid_.positions().bytes());
    stream_.end();
    stream_.submitAndWait();
    vectors_.accept();
    grid_.noteNewest(true);
  }
}

}  // namespace morphgrid
