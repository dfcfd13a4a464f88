#include "solve/imperfection.h"

#include <gtest/gtest.h>

#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

Eigen::Matrix3Xd movesOf(const StrutGrid& grid) {
  return withImperfection(grid, grid.positions) - grid.positions;
}

TEST(Imperfection, IsSmallBesideTheShortestStrut) {
  const StrutGrid grid = bentGrid({9, 6, 3}, 1);  // Layers 0.3 apart.
  const Eigen::Matrix3Xd moves = movesOf(grid);
  EXPECT_GT(moves.norm(), 0);
  EXPECT_LT(moves.colwise().norm().maxCoeff(), 0.25 * 0.3);
}

TEST(Imperfection, MovesColumnsRigidly) {
  const StrutGrid grid = bentGrid({9, 6, 3}, 1);
  const Eigen::Matrix3Xd moves = movesOf(grid);
  const int count = grid.shape.layerVertexCount();
  EXPECT_LT((moves.leftCols(count) - moves.rightCols(count)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Imperfection, HasNoSymmetry) {
  constexpr int kCount = 8;
  const StrutGrid grid = bentGrid({kCount, kCount, 2}, 1);
  const Eigen::Matrix3Xd moves = movesOf(grid);
  Eigen::MatrixXd heights(kCount, kCount);
  for (int j = 0; j < kCount; ++j) {
    for (int i = 0; i < kCount; ++i) {
      heights(i, j) = moves(2, grid.shape.index(i, j, 0));
    }
  }
  const Eigen::MatrixXd mirrored = heights.colwise().reverse();
  const Eigen::MatrixXd turned = mirrored.rowwise().reverse();
  for (const Eigen::MatrixXd& image :
       {mirrored, turned, Eigen::MatrixXd(heights.rowwise().reverse()),
        Eigen::MatrixXd(heights.transpose()), Eigen::MatrixXd(mirrored.transpose())}) {
    EXPECT_GT((heights - image).norm(), 0.1 * heights.norm());
    EXPECT_GT((heights + image).norm(), 0.1 * heights.norm());
  }
}

TEST(Imperfection, LeavesOneLayerInItsPlane) {
  EXPECT_TRUE(movesOf(bentGrid({9, 6, 1}, 1)).isZero(0));
}

}  // namespace
}  // namespace morphgrid
