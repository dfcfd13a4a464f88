#include "grid/joint_rotations.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <vector>

namespace morphgrid {

JointRotations unturnedJoints(int vertexCount) {
  JointRotations rotations = JointRotations::Zero(4, vertexCount);
  rotations.row(3).setOnes();
  return rotations;
}

JointRotations turnWithBars(const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  if (!grid.bars) {
    return {};
  }
  std::vector<Eigen::Matrix3d> products(grid.shape.vertexCount(), Eigen::Matrix3d::Zero());
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const Eigen::Vector3d now = (positions.col(strut.to) - positions.col(strut.from)).normalized();
    const Eigen::Matrix3d product = now * printedDirection(*grid.bars, strut).transpose();
    products[strut.from] += product;
    products[strut.to] += product;
  });
  JointRotations rotations(4, grid.shape.vertexCount());
  for (Eigen::Index n = 0; n < rotations.cols(); ++n) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products[n],
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    mirror(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    rotations.col(n) =
        Eigen::Quaterniond(svd.matrixU() * mirror * svd.matrixV().transpose()).coeffs();
  }
  return rotations;
}

}  // namespace morphgrid
