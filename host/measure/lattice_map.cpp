#include "measure/lattice_map.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Area over squared longest side below which a triangle counts as collapsed.
constexpr double kFlattest = 1e-9;

double cotangent(const Vector3d& apex, const Vector3d& a, const Vector3d& b) {
  return (a - apex).dot(b - apex) / (a - apex).cross(b - apex).norm();
}

/// Of the two diagonals at most one has a negative weight, which could take values beyond their
/// neighbours'.
Eigen::Matrix3Xi cutCells(const PointLattice& lattice) {
  Eigen::Matrix3Xi triangles(3, 2 * (lattice.countU - 1) * (lattice.countV - 1));
  Eigen::Index next = 0;
  for (int j = 0; j + 1 < lattice.countV; ++j) {
    for (int i = 0; i + 1 < lattice.countU; ++i) {
      const int cell[] = {lattice.index(i, j), lattice.index(i + 1, j), lattice.index(i + 1, j + 1),
                          lattice.index(i, j + 1)};
      const auto cornerCotangent = [&](int corner) {
        return cotangent(lattice.points.col(cell[corner]),
                         lattice.points.col(cell[(corner + 1) % 4]),
                         lattice.points.col(cell[(corner + 3) % 4]));
      };
      // The diagonal from corner `first` to the opposite one.
      const int first = cornerCotangent(1) + cornerCotangent(3) >= 0 ? 0 : 1;
      for (const int second : {first + 1, first + 2}) {
        triangles.col(next++) << cell[first], cell[second], cell[(second + 1) % 4];
      }
    }
  }
  return triangles;
}

void requireArea(const PointLattice& lattice, const Eigen::Matrix3Xi& triangles) {
  for (const auto& triangle : triangles.colwise()) {
    const Eigen::Matrix3d corners = lattice.points(Eigen::all, triangle);
    const Vector3d a = corners.col(1) - corners.col(0);
    const Vector3d b = corners.col(2) - corners.col(0);
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    if (!(a.cross(b).norm() > kFlattest * longest)) {
      const Eigen::Vector2d at = parametersOf(lattice, triangle[0]);
      throw InputError(fmt::format(
          "the surface has no area near ({:.4g}, {:.4g}, {:.4g}), at u = {:.4g}, v = {:.4g} of "
          "[0, 1], and no net but that of its isolines; take design.net = \"isoline\"",
          corners(0, 0), corners(1, 0), corners(2, 0), at.x(), at.y()));
    }
  }
}

/// What makes the form least and is 0 and 1 on two opposite sides; `place` of a point runs from 0
/// to `last` between them.
template <typename Place>
VectorXd leastBetweenSides(const SparseMatrix& form, const Place& place, int last) {
  VectorXd values = VectorXd::Zero(form.cols());
  std::vector<int> unknownOf(form.cols(), -1);
  int unknowns = 0;
  for (int point = 0; point < form.cols(); ++point) {
    if (place(point) == last) {
      values[point] = 1;
    } else if (place(point) > 0) {
      unknownOf[point] = unknowns++;
    }
  }
  const VectorXd known = form * values;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(form.nonZeros());
  VectorXd right(unknowns);
  for (int point = 0; point < form.cols(); ++point) {
    if (unknownOf[point] < 0) continue;
    right[unknownOf[point]] = -known[point];
    for (SparseMatrix::InnerIterator entry(form, point); entry; ++entry) {
      if (unknownOf[entry.row()] >= 0) {
        entries.emplace_back(unknownOf[entry.row()], unknownOf[point], entry.value());
      }
    }
  }
  SparseMatrix inner(unknowns, unknowns);
  inner.setFromTriplets(entries.begin(), entries.end());
  const VectorXd solution = Eigen::SimplicialLDLT<SparseMatrix>(inner).solve(right);
  for (int point = 0; point < form.cols(); ++point) {
    if (unknownOf[point] >= 0) values[point] = solution[unknownOf[point]];
  }
  return values;
}

}  // namespace

Eigen::Matrix3Xi triangulate(const PointLattice& lattice) {
  Eigen::Matrix3Xi triangles = cutCells(lattice);
  requireArea(lattice, triangles);
  return triangles;
}

Eigen::Vector2d parametersOf(const PointLattice& lattice, int point) {
  const int row = point / lattice.countU;
  return {double(point % lattice.countU) / (lattice.countU - 1),
          double(row) / (lattice.countV - 1)};
}

SparseMatrix cotangentLaplacian(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xi& triangles) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * triangles.cols());
  for (const auto& triangle : triangles.colwise()) {
    for (int corner = 0; corner < 3; ++corner) {
      const int apex = triangle[corner];
      const int a = triangle[(corner + 1) % 3];
      const int b = triangle[(corner + 2) % 3];
      const double weight = cotangent(points.col(apex), points.col(a), points.col(b)) / 2;
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
    }
  }
  SparseMatrix laplacian(points.cols(), points.cols());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

LatticeMap solveMap(const PointLattice& lattice, Eigen::Matrix3Xi triangles,
                    const SparseMatrix& ofU, const SparseMatrix& ofV) {
  LatticeMap map{lattice.countU, lattice.countV, Eigen::Matrix2Xd(2, lattice.points.cols()),
                 std::move(triangles), 0};
  const VectorXd u = leastBetweenSides(
      ofU, [&](int point) { return point % lattice.countU; }, lattice.countU - 1);
  const VectorXd v = leastBetweenSides(
      ofV, [&](int point) { return point / lattice.countU; }, lattice.countV - 1);
  if (!u.allFinite() || !v.allFinite()) {
    throw InputError(
        "the surface is too rough for any net but its isolines; take design.net = \"isoline\"");
  }
  map.values << u.transpose(), v.transpose();
  // The energies of a conformal map's u and v are the modulus and its inverse, both from above.
  const SparseMatrix laplacian = cotangentLaplacian(lattice.points, map.triangles);
  map.modulus = std::sqrt(u.dot(laplacian * u) / v.dot(laplacian * v));
  return map;
}

}  // namespace morphgrid
