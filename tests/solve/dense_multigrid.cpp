#include "tests/solve/dense_multigrid.h"

#include <Eigen/Geometry>
#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix3d crossMatrix(const Vector3d& y) {
  Matrix3d m;
  m << 0, -y.z(), y.y(), y.z(), 0, -y.x(), -y.y(), y.x(), 0;
  return m;
}

/// Linear interpolation along a row of n points from every second one and the last.
MatrixXd rowInterpolation(int n) {
  std::vector<int> kept;
  for (int i = 0; i < n - 1; i += 2) {
    kept.push_back(i);
  }
  kept.push_back(n - 1);
  MatrixXd shares = MatrixXd::Zero(n, static_cast<Index>(kept.size()));
  for (std::size_t c = 0; c + 1 < kept.size(); ++c) {
    for (int i = kept[c]; i <= kept[c + 1]; ++i) {
      const double second = double(i - kept[c]) / (kept[c + 1] - kept[c]);
      shares(i, static_cast<Index>(c)) = 1 - second;
      shares(i, static_cast<Index>(c) + 1) = second;
    }
  }
  return shares;
}

/// phi: points x coarse points.
MatrixXd interpolationShares(PointGrid points) {
  const MatrixXd u = rowInterpolation(points.u);
  const MatrixXd v = rowInterpolation(points.v);
  MatrixXd shares(points.count(), u.cols() * v.cols());
  for (Index row = 0; row < shares.rows(); ++row) {
    for (Index column = 0; column < shares.cols(); ++column) {
      shares(row, column) =
          u(row % points.u, column % u.cols()) * v(row / points.u, column / u.cols());
    }
  }
  return shares;
}

MatrixXd downloadField(const Device& device, const BlockField& field, Index count) {
  MatrixXd blocks(6, 6 * count);
  for (Index part = 0; part < 3; ++part) {
    const auto texels = download<vec4>(device, field.part(static_cast<std::size_t>(part)).buffer(),
                                       static_cast<std::size_t>(3 * count));
    for (Index column = 0; column < 3; ++column) {
      for (Index point = 0; point < count; ++point) {
        const vec4 texel = texels[static_cast<std::size_t>(3 * point + column)];
        const Vector3d quarter(texel.x, texel.y, texel.z);
        const Index left = 6 * point;
        if (part == 1) {
          blocks.block<3, 1>(0, left + 3 + column) = quarter;
        } else {
          blocks.block<3, 1>(part == 0 ? 0 : 3, left + column) = quarter;
        }
        blocks(3 + column, left + 3 + part) = texel.w;
      }
    }
  }
  return blocks;
}

}  // namespace

MatrixXd denseColumnProlongation(const GridShape& shape, const Matrix3Xd& positions) {
  const Index columns = shape.layerVertexCount();
  const Index middle = shape.layers / 2 * columns;
  MatrixXd prolongation = MatrixXd::Zero(3 * positions.cols(), 6 * columns);
  for (Index vertex = 0; vertex < positions.cols(); ++vertex) {
    const Index column = vertex % columns;
    const Vector3d lever = positions.col(vertex) - positions.col(middle + column);
    prolongation.block<3, 3>(3 * vertex, 6 * column).setIdentity();
    prolongation.block<3, 3>(3 * vertex, 6 * column + 3) = -crossMatrix(lever);
  }
  return prolongation;
}

MatrixXd densePointProlongation(PointGrid points, const Matrix3Xd& centres) {
  const MatrixXd shares = interpolationShares(points);
  const Matrix3Xd coarse = keptCentres(points, centres);
  MatrixXd prolongation = MatrixXd::Zero(6 * shares.rows(), 6 * shares.cols());
  for (Index p = 0; p < shares.rows(); ++p) {
    const Vector3d interpolated = coarse * shares.row(p).transpose();
    for (Index c = 0; c < shares.cols(); ++c) {
      const Vector3d lever = centres.col(p) - (interpolated + coarse.col(c)) / 2;
      auto block = prolongation.block<6, 6>(6 * p, 6 * c);
      block.setIdentity();
      block.topRightCorner<3, 3>() = -crossMatrix(lever);
      block *= shares(p, c);
    }
  }
  return prolongation;
}

Matrix3Xd keptCentres(PointGrid points, const Matrix3Xd& centres) {
  const MatrixXd shares = interpolationShares(points);
  Matrix3Xd kept(3, shares.cols());
  for (Index c = 0; c < shares.cols(); ++c) {
    for (Index p = 0; p < shares.rows(); ++p) {
      if (shares(p, c) == 1) {
        kept.col(c) = centres.col(p);
      }
    }
  }
  return kept;
}

VectorXd rigidMotion(const Matrix3Xd& centres, const Eigen::Matrix<double, 6, 1>& motion) {
  VectorXd motions(6 * centres.cols());
  for (Index n = 0; n < centres.cols(); ++n) {
    motions.segment<3>(6 * n) = motion.head<3>() + motion.tail<3>().cross(centres.col(n));
    motions.segment<3>(6 * n + 3) = motion.tail<3>();
  }
  return motions;
}

MatrixXd downloadMatrix(const Device& device, const PointLevel& level) {
  const int width = level.points().u;
  const Index count = level.points().count();
  MatrixXd matrix = MatrixXd::Zero(6 * count, 6 * count);
  const std::vector<Eigen::Vector2i> offsets{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {-1, 1}};
  for (std::size_t direction = 0; direction < offsets.size(); ++direction) {
    const MatrixXd blocks = downloadField(device, level.blocks(direction), count);
    for (int p = 0; p < count; ++p) {
      const int u = p % width + offsets[direction].x();
      const int v = p / width + offsets[direction].y();
      if (u < 0 || u >= width || v >= level.points().v) {
        continue;
      }
      const Index q = Index(v) * width + u;
      matrix.block<6, 6>(6 * p, 6 * q) = blocks.middleCols<6>(6 * p);
      if (direction > 0) {
        matrix.block<6, 6>(6 * q, 6 * p) = blocks.middleCols<6>(6 * p).transpose();
      }
    }
  }
  return matrix;
}

MatrixXd downloadInverse(const Device& device, const PointLevel& level) {
  const Index count = level.points().count();
  const MatrixXd blocks = downloadField(device, level.inverse(), count);
  MatrixXd matrix = MatrixXd::Zero(6 * count, 6 * count);
  for (Index p = 0; p < count; ++p) {
    matrix.block<6, 6>(6 * p, 6 * p) = blocks.middleCols<6>(6 * p);
  }
  return matrix;
}

VectorXd downloadMotions(const Device& device, const TexelBuffer& motions) {
  const std::size_t halves = motions.buffer().bytes() / sizeof(vec4);
  const auto packed = download<vec4>(device, motions.buffer(), halves);
  VectorXd values(static_cast<Index>(3 * halves));
  for (std::size_t n = 0; n < halves; ++n) {
    values.segment<3>(static_cast<Index>(3 * n)) = Vector3d(packed[n].x, packed[n].y, packed[n].z);
  }
  return values;
}

void uploadMotions(const Device& device, const TexelBuffer& motions, const VectorXd& values) {
  std::vector<vec4> packed;
  for (Index n = 0; n < values.size(); n += 3) {
    packed.emplace_back(values[n], values[n + 1], values[n + 2], 0);
  }
  upload(device, motions.buffer(), packed);
}

}  // namespace morphgrid
