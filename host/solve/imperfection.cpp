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

/// At a place in [0, 1] x [0, 1].
Eigen::Vector3d waves(double u, double v) {
  std::mt19937 random(1);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int q = 0; q < kWaves; ++q) {
    for (int p = 0; p < kWaves; ++p) {
      const double wave = std::cos(std::numbers::pi * p * u) * std::cos(std::numbers::pi * q * v);
      for (double& component : sum) {
        component += wave * (2.0 * random() / std::mt19937::max() - 1);
      }
    }
  }
  return sum;
}

}  // namespace

Eigen::Matrix3Xd withImperfection(const StrutGrid& grid, Eigen::Matrix3Xd positions) {
  const GridShape& shape = grid.shape;
  if (shape.layers == 1) {
    return positions;
  }
  const double amplitude = kAmplitude * shortestRestLength(grid);
  forEachVertex(shape.layer(), [&](const GridPlace& place) {
    const Eigen::Vector3d move =
        amplitude * waves(double(place.i) / shape.cellsU(), double(place.j) / shape.cellsV());
    for (int k = 0; k < shape.layers; ++k) {
      positions.col(shape.index(place.i, place.j, k)) += move;
    }
  });
  return positions;
}

}  // namespace morphgrid
