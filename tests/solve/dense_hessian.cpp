#include "tests/solve/dense_hessian.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

#include "energy/strut_energy.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

void addLink(MatrixXd& matrix, const Strut& strut, const Matrix3d& block) {
  const int from = 3 * strut.from;
  const int to = 3 * strut.to;
  matrix.block<3, 3>(from, from) += block;
  matrix.block<3, 3>(to, to) += block;
  matrix.block<3, 3>(from, to) -= block;
  matrix.block<3, 3>(to, from) -= block;
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double cornerResidual(double restAngle, const Vector3d& apex, const Vector3d& endA,
                      const Vector3d& endB) {
  const Vector3d a = endA - apex;
  const Vector3d b = endB - apex;
  const double t = a.squaredNorm() + b.squaredNorm();
  const double s = a.norm() * b.norm() * std::sin(restAngle - angleBetween(a, b));
  return s * std::sqrt(2 / (t + std::sqrt(t * t - 4 * s * s)));
}

/// d residual / d (apex, a, b), by differences of fourth order.
Eigen::Matrix<double, 9, 1> cornerDerivative(double restAngle,
                                             const std::array<Vector3d, 3>& points) {
  constexpr double kStep = 1e-3;
  Eigen::Matrix<double, 9, 1> derivative;
  for (int n = 0; n < 9; ++n) {
    const auto at = [&](double steps) {
      std::array<Vector3d, 3> moved = points;
      moved[n / 3][n % 3] += steps * kStep;
      return cornerResidual(restAngle, moved[0], moved[1], moved[2]);
    };
    derivative[n] = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * kStep);
  }
  return derivative;
}

void addCorner(MatrixXd& matrix, const Corner& corner, const StrutGrid& grid,
               const Eigen::Matrix3Xd& x) {
  const std::array<int, 3> vertices{corner.apex, corner.a, corner.b};
  double restAngle = std::numbers::pi / 2;
  if (grid.printedCorners && corner.isLateral) {
    const auto& printed = *grid.printedCorners;
    restAngle = angleBetween(printed.col(corner.a) - printed.col(corner.apex),
                             printed.col(corner.b) - printed.col(corner.apex));
  }
  const double weight = corner.isLateral ? grid.weights.angle : grid.weights.postAngle;
  const auto j =
      cornerDerivative(restAngle, {x.col(corner.apex), x.col(corner.a), x.col(corner.b)});
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix.block<3, 3>(3 * vertices[row], 3 * vertices[column]) +=
          2 * weight * j.segment<3>(3 * row) * j.segment<3>(3 * column).transpose();
    }
  }
}

}  // namespace

MatrixXd denseHessian(const StrutGrid& grid) {
  const int size = 3 * grid.shape.vertexCount();
  const Eigen::Matrix3Xd x = grid.positions / grid.spacing;
  MatrixXd matrix = MatrixXd::Zero(size, size);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const Vector3d e = x.col(strut.to) - x.col(strut.from);
    const Matrix3d along = e * e.transpose() / e.squaredNorm();
    const double stretch = 1 - valueAt(grid.rest, strut) / grid.spacing / e.norm();
    addLink(matrix, strut,
            2 * valueAt(grid.stiffness, strut) *
                (along + std::max(0.0, stretch) * (Matrix3d::Identity() - along)));
  });
  forEachCorner(grid.shape, [&](const Corner& corner) { addCorner(matrix, corner, grid, x); });
  return matrix;
}

MatrixXd denseExactHessian(const StrutGrid& grid) {
  const double step = 1e-3 * grid.spacing;
  const StrutEnergy energy(grid);
  MatrixXd matrix(grid.positions.size(), grid.positions.size());
  for (Eigen::Index n = 0; n < matrix.cols(); ++n) {
    const auto at = [&](double steps) {
      Eigen::Matrix3Xd moved = grid.positions;
      moved(n % 3, n / 3) += steps * step;
      return energy.evaluate(moved).gradient;
    };
    const Eigen::Matrix3Xd change = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
    matrix.col(n) = change.reshaped();
  }
  return matrix;
}

MatrixXd denseLaplacian(const GridShape& shape) {
  MatrixXd matrix = MatrixXd::Zero(3 * shape.vertexCount(), 3 * shape.vertexCount());
  forEachStrut(shape, [&](const Strut& strut) { addLink(matrix, strut, Matrix3d::Identity()); });
  return matrix;
}

MatrixXd diagonalBlocks(const MatrixXd& matrix) {
  MatrixXd blocks = MatrixXd::Zero(matrix.rows(), matrix.cols());
  for (Eigen::Index n = 0; n < matrix.rows(); n += 3) {
    blocks.block<3, 3>(n, n) = matrix.block<3, 3>(n, n);
  }
  return blocks;
}

MatrixXd invertedBlocks(const MatrixXd& blocks) {
  MatrixXd inverse = MatrixXd::Zero(blocks.rows(), blocks.cols());
  for (Eigen::Index n = 0; n < blocks.rows(); n += 3) {
    const Matrix3d block = blocks.block<3, 3>(n, n);
    inverse.block<3, 3>(n, n) = block.completeOrthogonalDecomposition().pseudoInverse();
  }
  return inverse;
}

}  // namespace morphgrid
