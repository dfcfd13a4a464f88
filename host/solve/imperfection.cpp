#include "solve/imperfection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace morphgrid {
namespace {

// Largest amplitude of a wave, in rest lengths of the shortest strut.
constexpr double kAmplitude = 0.01;
constexpr int kWaves = 4;  // Along u and along v.

double shortestRestLength(const StrutGrid& grid) {
  double shortest = std::numeric_limits<double>::infinity();
  forEachStrut(grid.shape, [&](const Strut& strut) {
    shortest = std::min(shortest, valueAt(grid.rest, strut));
  });
  return shortest;
}

/// cos(pi p i / cells) at (i, p).
Eigen::MatrixXd cosines(int cells) {
  return Eigen::MatrixXd::NullaryExpr(cells + 1, kWaves, [&](Eigen::Index i, Eigen::Index p) {
    return std::cos(std::numbers::pi * double(p) * (double(i) / cells));
  });
}

/// A sum of waves along u and v, of random heights, always the same.
class Waves {
 public:
  explicit Waves(const GridShape& shape)
      : alongU_(cosines(shape.cellsU())), alongV_(cosines(shape.cellsV())) {
    std::mt19937 random(1);
    for (double& height : heights_.reshaped()) {
      height = 2.0 * random() / std::mt19937::max() - 1;
    }
  }

  Eigen::Vector3d at(int i, int j) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int q = 0; q < kWaves; ++q) {
      for (int p = 0; p < kWaves; ++p) {
        sum += alongU_(i, p) * alongV_(j, q) * heights_.col(q * kWaves + p);
      }
    }
    return sum;
  }

 private:
  Eigen::MatrixXd alongU_, alongV_;
  Eigen::Matrix<double, 3, kWaves * kWaves> heights_;
};

}  // namespace

Eigen::Matrix3Xd withImperfection(const StrutGrid& grid, Eigen::Matrix3Xd positions) {
  const GridShape& shape = grid.shape;
  if (shape.layers == 1) {
    return positions;
  }
  const double amplitude = kAmplitude * shortestRestLength(grid);
  const Waves waves(shape);
  forEachVertex(shape.layer(), [&](const GridPlace& place) {
    const Eigen::Vector3d move = amplitude * waves.at(place.i, place.j);
    for (int k = 0; k < shape.layers; ++k) {
      positions.col(shape.index(place.i, place.j, k)) += move;
    }
  });
  return positions;
}

}  // namespace morphgrid
