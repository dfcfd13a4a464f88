#include "energy/frame_energy.h"

#include <Eigen/Eigenvalues>
#include <vector>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;

/// The transposed of changeOfEnds().
void addToEnds(const Edge& edge, const Vector9d& values, Matrix3Xd& unknowns) {
  const Eigen::Index count = unknowns.cols() / 2;
  unknowns.col(edge.to) += values.head<3>();
  unknowns.col(edge.from) -= values.head<3>();
  unknowns.col(count + edge.from) += values.segment<3>(3);
  unknowns.col(count + edge.to) += values.tail<3>();
}

Matrix9d positivePart(const Matrix9d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix9d> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// From (displacement, turn) of a and of b to the nine unknowns of a bar.
Eigen::Matrix<double, 9, 12> nineOfTwelve() {
  Eigen::Matrix<double, 9, 12> result = Eigen::Matrix<double, 9, 12>::Zero();
  result.block<3, 3>(0, 0) = -Eigen::Matrix3d::Identity();
  result.block<3, 3>(0, 6).setIdentity();
  result.block<3, 3>(3, 3).setIdentity();
  result.block<3, 3>(6, 9).setIdentity();
  return result;
}

}  // namespace

BeamTerm::Ends<double> FramePlacement::endsOf(const BeamTerm& term, const Edge& edge) const {
  return term.endsAt(positions.col(edge.to) - positions.col(edge.from), rotationOf(edge.from),
                     rotationOf(edge.to));
}

BeamTerm::Vector9<double> changeOfEnds(const Edge& edge, const Matrix3Xd& unknowns) {
  const Eigen::Index count = unknowns.cols() / 2;
  BeamTerm::Vector9<double> result;
  result << unknowns.col(edge.to) - unknowns.col(edge.from), unknowns.col(count + edge.from),
      unknowns.col(count + edge.to);
  return result;
}

FrameEnergy::Value FrameEnergy::evaluate(const Matrix3Xd& positions,
                                         const JointRotations& rotations) const {
  const FramePlacement place{positions, rotations};
  Value value{0, Matrix3Xd::Zero(3, 2 * positions.cols())};
  BeamTerm::forEach(grid_, [&](const BeamTerm& term, const Edge& edge) {
    const BeamTerm::Value at = term.evaluate(place.endsOf(term, edge));
    value.energy += at.energy;
    addToEnds(edge, at.gradient, value.gradient);
  });
  JointTerm::forEach(grid_, [&](const JointTerm& term, int joint) {
    const JointTerm::Value at = term.evaluate(positions.col(joint), place.rotationOf(joint));
    value.energy += at.energy;
    value.gradient.col(joint) += at.force;
    value.gradient.col(positions.cols() + joint) += at.moment;
  });
  return value;
}

Eigen::SparseMatrix<double> FrameEnergy::hessian(const Matrix3Xd& positions,
                                                 const JointRotations& rotations,
                                                 Definiteness definiteness) const {
  const FramePlacement place{positions, rotations};
  const Eigen::Matrix<double, 9, 12> spread = nineOfTwelve();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(78) * grid_.shape.strutCount());
  BeamTerm::forEach(grid_, [&](const BeamTerm& term, const Edge& edge) {
    const Matrix9d exact = term.hessian(place.endsOf(term, edge));
    Matrix9d symmetric = (exact + exact.transpose()) / 2;
    if (definiteness == Definiteness::positiveParts) {
      symmetric = positivePart(symmetric);
    }
    const Eigen::Matrix<double, 12, 12> block = spread.transpose() * symmetric * spread;
    const auto unknown = [&](int n) { return 6 * (n < 6 ? edge.from : edge.to) + n % 6; };
    for (int column = 0; column < 12; ++column) {
      for (int row = 0; row < 12; ++row) {
        if (unknown(row) >= unknown(column)) {
          entries.emplace_back(unknown(row), unknown(column), block(row, column));
        }
      }
    }
  });
  JointTerm::forEach(grid_, [&](const JointTerm& term, int joint) {
    const Eigen::Matrix3d exact = term.momentByTurn(place.rotationOf(joint));
    for (int column = 0; column < 3; ++column) {
      entries.emplace_back(6 * joint + column, 6 * joint + column, term.holding[column]);
      for (int row = column; row < 3; ++row) {
        entries.emplace_back(6 * joint + 3 + row, 6 * joint + 3 + column,
                             (exact(row, column) + exact(column, row)) / 2);
      }
    }
  });
  const int size = 6 * grid_.shape.vertexCount();
  Eigen::SparseMatrix<double> hessian(size, size);
  hessian.setFromTriplets(entries.begin(), entries.end());
  return hessian;
}

Matrix3Xd FrameEnergy::hessianProduct(const Matrix3Xd& positions, const JointRotations& rotations,
                                      const Matrix3Xd& motion) const {
  const FramePlacement place{positions, rotations};
  Matrix3Xd result = Matrix3Xd::Zero(3, motion.cols());
  BeamTerm::forEach(grid_, [&](const BeamTerm& term, const Edge& edge) {
    addToEnds(edge, term.hessian(place.endsOf(term, edge)) * changeOfEnds(edge, motion), result);
  });
  JointTerm::forEach(grid_, [&](const JointTerm& term, int joint) {
    const Eigen::Index turn = positions.cols() + joint;
    result.col(joint) += term.holding.cwiseProduct(motion.col(joint));
    result.col(turn) += term.momentByTurn(place.rotationOf(joint)) * motion.col(turn);
  });
  return result;
}

}  // namespace morphgrid
