#include "measure/principal_map.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// More follows the lines closer and makes struts less even (docs/decisions/0014).
constexpr double kStrength = 30;

/// Of `integral of |grad f|^2 + extra (grad f . along)^2` for linear elements; along: a unit vector
/// in each triangle's plane.
SparseMatrix anisotropicLaplacian(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xi& triangles,
                                  const Eigen::Matrix3Xd& along, const VectorXd& extra) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Matrix3d corners = points(Eigen::all, triangles.col(t));
    const Vector3d normal =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double twiceArea = normal.norm();
    Eigen::Matrix3d slopes;  // Of the hat functions.
    for (int n = 0; n < 3; ++n) {
      slopes.col(n) = normal.cross(corners.col((n + 2) % 3) - corners.col((n + 1) % 3)) /
                      (twiceArea * twiceArea);
    }
    const Vector3d slopesAlong = slopes.transpose() * along.col(t);
    const Eigen::Matrix3d block =
        twiceArea / 2 *
        (slopes.transpose() * slopes + extra[t] * slopesAlong * slopesAlong.transpose());
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        entries.emplace_back(triangles(row, t), triangles(column, t), block(row, column));
      }
    }
  }
  SparseMatrix laplacian(points.cols(), points.cols());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

struct CurvatureLines {
  Eigen::Matrix3Xd alongU, alongV;  ///< Principal directions of each triangle: nearer to +u, to +v.
  VectorXd difference;              ///< |kappa_1 - kappa_2|
  VectorXd clarity;                 ///< 1: along the isolines, 0: at 45 degrees to them.
};

CurvatureLines findCurvatureLines(const PointLattice& lattice, const Eigen::Matrix3Xd& normals,
                                  const Eigen::Matrix3Xi& triangles) {
  const Eigen::Index count = triangles.cols();
  CurvatureLines lines{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), VectorXd(count),
                       VectorXd(count)};
  for (Eigen::Index t = 0; t < count; ++t) {
    const Eigen::Matrix3d p = lattice.points(Eigen::all, triangles.col(t));
    const Eigen::Matrix3d n = normals(Eigen::all, triangles.col(t));
    Eigen::Matrix<double, 3, 2> edges, turns;
    edges << p.col(1) - p.col(0), p.col(2) - p.col(0);
    turns << n.col(1) - n.col(0), n.col(2) - n.col(0);
    const Vector3d normal = edges.col(0).cross(edges.col(1)).normalized();
    // +u within the triangle: from the parameters of its corners.
    Eigen::Matrix2d steps;
    const Eigen::Vector2d origin = parametersOf(lattice, triangles(0, t));
    steps << parametersOf(lattice, triangles(1, t)) - origin,
        parametersOf(lattice, triangles(2, t)) - origin;
    const Vector3d x = (edges * steps.inverse().col(0)).normalized();
    const Vector3d y = normal.cross(x);
    Eigen::Matrix<double, 3, 2> frame;
    frame << x, y;
    const Eigen::Matrix2d inPlane = frame.transpose() * edges;
    const Eigen::Matrix2d shape = frame.transpose() * turns * inPlane.inverse();
    const double a = (shape(0, 0) - shape(1, 1)) / 2;
    const double b = (shape(0, 1) + shape(1, 0)) / 2;
    // Of one principal direction, in (-90, 90] degrees; the other is a quarter turn away.
    const double angle = 0.5 * std::atan2(b, a);
    const double nearer = std::remainder(angle, std::numbers::pi / 2);
    lines.alongU.col(t) = std::cos(nearer) * x + std::sin(nearer) * y;
    lines.alongV.col(t) = -std::sin(nearer) * x + std::cos(nearer) * y;
    lines.difference[t] = 2 * std::hypot(a, b);
    lines.clarity[t] = std::cos(2 * nearer);
  }
  return lines;
}

}  // namespace

LatticeMap mapAlongCurvature(const PointLattice& lattice, const Eigen::Matrix3Xd& normals) {
  Eigen::Matrix3Xi triangles = triangulate(lattice);
  const CurvatureLines lines = findCurvatureLines(lattice, normals, triangles);
  const double usual = std::sqrt(lines.difference.squaredNorm() / double(lines.difference.size()));
  VectorXd extra = VectorXd::Zero(triangles.cols());
  if (usual > 0) {
    extra = kStrength * (lines.difference.array() / usual).square().min(1.0) *
            lines.clarity.array().square();
  }
  const SparseMatrix ofU = anisotropicLaplacian(lattice.points, triangles, lines.alongV, extra);
  const SparseMatrix ofV = anisotropicLaplacian(lattice.points, triangles, lines.alongU, extra);
  return solveMap(lattice, std::move(triangles), ofU, ofV);
}

}  // namespace morphgrid
