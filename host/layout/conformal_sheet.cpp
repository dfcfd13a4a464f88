#include "layout/conformal_sheet.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "layout/coarse_sheet.h"
#include "layout/sheet_energy.h"

namespace morphgrid {
namespace {

using Eigen::Matrix2Xd;
using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

constexpr int kIterationLimit = 200;
// Nets of more joints are laid out from that of every other line on, or of fewer.
constexpr int kMostDirect = 1500;
// What is left then is local, and few steps take it out; beyond so many joints it is left.
constexpr int kMostPolished = 6000;
constexpr int kPolishing = 6;
constexpr int kLineSearchSteps = 20;
// A step of less than so many mean chords changes no angle.
constexpr double kSmallStep = 1e-5;
constexpr double kLargestStep = 1;
// It ends when the energy has fallen by less than this share in so many steps: bars that come to
// the bounds of the range and leave them keep it from converging faster.
constexpr std::size_t kPatience = 8;
constexpr double kLeastFall = 0.01;
// No step makes a corner of a cell flatter than this sine, or than it is.
constexpr double kLeastSine = 0.1;
// Of Levenberg and Marquardt.
constexpr double kFirstDamping = 1e-6;
constexpr double kLeastDamping = 1e-9;
constexpr double kLargestDamping = 1;

struct SharpestCorner {
  double sine = 1;
  GridPlace cell{};
};

SharpestCorner sharpestCorner(const GridShape& layer, const Matrix2Xd& positions) {
  SharpestCorner sharpest;
  forEachCell(layer, [&](const Cell& cell) {
    const auto ring = cell.ring();
    for (int n = 0; n < 4; ++n) {
      const Eigen::Vector2d a = positions.col(ring[(n + 1) % 4]) - positions.col(ring[n]);
      const Eigen::Vector2d b = positions.col(ring[(n + 3) % 4]) - positions.col(ring[n]);
      const double sine = (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm());
      if (!(sine >= sharpest.sine)) {
        sharpest = {sine, cell.place};
      }
    }
  });
  return sharpest;
}

/// A layer without folds is one to one if its rim does not cross itself.
bool overlapsItself(const GridShape& layer, const Matrix2Xd& positions) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> rim;
  const auto add = [&](int i, int j) {
    const Eigen::Vector2d at = positions.col(layer.index(i, j, 0));
    rim.emplace_back(at.x(), at.y());
  };
  for (int i = 0; i < layer.cellsU(); ++i) add(i, 0);
  for (int j = 0; j < layer.cellsV(); ++j) add(layer.cellsU(), j);
  for (int i = layer.cellsU(); i > 0; --i) add(i, layer.cellsV());
  for (int j = layer.cellsV(); j > 0; --j) add(0, j);
  return !CGAL::is_simple_2(rim.begin(), rim.end(),
                            CGAL::Exact_predicates_inexact_constructions_kernel());
}

double largestMove(const VectorXd& step) {
  double largest = 0;
  for (Eigen::Index n = 0; n < step.size(); n += 3) {
    largest = std::max(largest, step.segment<2>(n).norm());
  }
  return largest;
}

class SheetSearch {
 public:
  /// Keeps no reference.
  SheetSearch(const SheetProblem& problem, const Matrix2Xd& start)
      : layer_(problem.layer), energy_(problem), unknowns_(energy_.unknownsAt(start)) {
    value_ = energy_.evaluate(unknowns_);
    sine_ = sharpestCorner(layer_, positions()).sine;
  }

  Matrix2Xd positions() const { return energy_.positionsOf(unknowns_); }

  /// False at the end.
  bool step() {
    values_.push_back(value_);
    const std::size_t count = values_.size();
    if (count > kPatience && value_ > (1 - kLeastFall) * values_[count - 1 - kPatience]) {
      return false;
    }
    SheetEnergy::Derivatives at = energy_.differentiate(unknowns_);
    for (; damping_ <= kLargestDamping; damping_ *= 100) {
      Eigen::SparseMatrix<double> damped = at.hessian;
      damped.diagonal().array() += damping_;
      if (!isAnalysed_) {
        factor_.analyzePattern(damped);
        isAnalysed_ = true;
      }
      factor_.factorize(damped);
      const VectorXd direction = -factor_.solve(at.gradient);
      const double move = largestMove(direction);
      if (factor_.info() == Eigen::Success && std::isfinite(move)) {
        if (const double length = searchLine(direction, std::min(1.0, kLargestStep / move));
            length > 0) {
          damping_ = std::max(kLeastDamping, damping_ / 4);
          return length * move > kSmallStep;
        }
        if (move < kSmallStep) return false;
      }
    }
    return false;
  }

 private:
  double searchLine(const VectorXd& direction, double longest) {
    double length = longest;
    for (int attempt = 0; attempt < kLineSearchSteps; ++attempt, length /= 2) {
      const VectorXd trial = unknowns_ + length * direction;
      const double value = energy_.evaluate(trial);
      if (!(value < value_)) continue;
      const double sine = sharpestCorner(layer_, energy_.positionsOf(trial)).sine;
      if (sine > std::min(kLeastSine, 0.99 * sine_)) {
        unknowns_ = trial;
        value_ = value;
        sine_ = sine;
        return length;
      }
    }
    return 0;
  }

  GridShape layer_;
  SheetEnergy energy_;
  VectorXd unknowns_;
  double value_;
  std::vector<double> values_;
  double sine_;
  double damping_ = kFirstDamping;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  bool isAnalysed_ = false;
};

/// Square cells: nothing is folded there.
Matrix2Xd squares(const GridShape& layer) {
  Matrix2Xd positions(2, layer.layerVertexCount());
  forEachVertex(layer, [&](const GridPlace& place) {
    positions.col(layer.index(place)) << place.i, place.j;
  });
  return positions;
}

Sheet search(const SheetProblem& problem, const Matrix2Xd& start, int iterationLimit,
             const Cancellation& cancellation) {
  SheetSearch search(problem, start);
  Sheet sheet;
  while (sheet.iterations < iterationLimit) {
    cancellation.check();
    ++sheet.iterations;
    if (!search.step()) break;
  }
  sheet.positions = search.positions();
  return sheet;
}

Sheet layNested(const SheetProblem& problem, const NetLines& lines,
                const Cancellation& cancellation) {
  if (problem.layer.layerVertexCount() <= kMostDirect) {
    const Matrix2Xd start = squares(problem.layer);
    return search(problem, SheetEnergy(problem).enlargement(start) * start, kIterationLimit,
                  cancellation);
  }
  const CoarseSheetProblem coarse(problem, lines, kMostPolished);
  const Sheet sheet = layNested(coarse.problem(), coarse.lines(), cancellation);
  const int iterations = problem.layer.layerVertexCount() <= kMostPolished ? kPolishing : 0;
  return search(problem, coarse.prolong(sheet.positions), iterations, cancellation);
}

}  // namespace

Sheet layConformally(const SheetProblem& problem, const Cancellation& cancellation) {
  const auto begin = Clock::now();
  Sheet sheet = layNested(problem, evenLines(problem.layer), cancellation);
  if (overlapsItself(problem.layer, sheet.positions)) {
    throw InputError(
        "the flat sheet overlaps itself, so that it cannot be printed: use design.layout = "
        "\"in_plane\", or cut the surface into parts that curve less");
  }
  sheet.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return sheet;
}

}  // namespace morphgrid
