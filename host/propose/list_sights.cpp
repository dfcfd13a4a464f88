#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "propose/sight.h"
#include "surface/main_extent.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAlike = 0.966;     // Cosine of 15 degrees: that near, an axis will do.
constexpr double kOpen = 0.3;        // Mean normal of a mesh that has a front; 0 of a closed one.
constexpr double kAxisDigits = 1e4;  // What people read in the configuration is what is used.
constexpr double kDegreesDigits = 100;

double roundedAt(double value, double digits) { return std::round(value * digits) / digits; }

/// Brings `direction` to +x and `up`, as far as it is at right angles to that, to +y.
Sight sightAlong(const std::string& name, const Vector3d& direction, const Vector3d& up) {
  Matrix3d rows;
  rows.row(0) = direction.normalized();
  rows.row(1) = (up - up.dot(rows.row(0)) * rows.row(0).transpose()).normalized();
  rows.row(2) = Vector3d(rows.row(0)).cross(Vector3d(rows.row(1)));
  const Eigen::AngleAxisd turn(rows);
  const Vector3d axis = turn.axis().unaryExpr([](double c) { return roundedAt(c, kAxisDigits); });
  return {name, axis, roundedAt(turn.angle() * 180 / std::numbers::pi, kDegreesDigits)};
}

/// The mean of the normals, weighted by area: no longer than 1.
Vector3d meanNormal(const TriangleMesh& mesh) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Vector3d corner = mesh.vertices.col(triangle[0]);
    const Vector3d first = mesh.vertices.col(triangle[1]) - corner;
    const Vector3d second = mesh.vertices.col(triangle[2]) - corner;
    sum += first.cross(second) / 2;
  }
  const double area = surfaceArea(mesh);
  return area > 0 ? Vector3d(sum / area) : Vector3d::Zero();
}

/// Columns: of the triangles' middles, weighted by area, the least extent first.
Matrix3d principalAxes(const TriangleMesh& mesh) {
  double area = 0;
  Vector3d mean = Vector3d::Zero();
  Matrix3d moments = Matrix3d::Zero();
  const Vector3d origin = boundingBox(mesh).center();
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Matrix3d corners = mesh.vertices(Eigen::all, triangle).colwise() - origin;
    const double weight = Vector3d(corners.col(1) - corners.col(0))
                              .cross(Vector3d(corners.col(2) - corners.col(0)))
                              .norm();
    const Vector3d middle = corners.rowwise().mean();
    area += weight;
    mean += weight * middle;
    moments += weight * middle * middle.transpose();
  }
  if (!(area > 0)) return Matrix3d::Identity();
  mean /= area;
  const Matrix3d covariance = moments / area - mean * mean.transpose();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors();
}

void addUnlessAlike(std::vector<Sight>& sights, const Sight& sight) {
  for (const Sight& other : sights) {
    if (other.direction().dot(sight.direction()) > kAlike) return;
  }
  sights.push_back(sight);
}

}  // namespace

Matrix3d Sight::rotation() const {
  const double angle = degrees * std::numbers::pi / 180;
  return Eigen::AngleAxisd(angle, axis.stableNormalized()).toRotationMatrix();
}

std::vector<Sight> listSights(const TriangleMesh& mesh) {
  std::vector<Sight> sights = {
      {"along -z", Vector3d::UnitY(), -90}, {"along +z", Vector3d::UnitY(), 90},
      {"along -y", Vector3d::UnitZ(), 90},  {"along +y", Vector3d::UnitZ(), -90},
      {"along +x", Vector3d::UnitY(), 0},   {"along -x", Vector3d::UnitY(), 180}};
  const Matrix3d axes = principalAxes(mesh);
  const Vector3d normal = meanNormal(mesh);
  if (normal.norm() > kOpen) {
    addUnlessAlike(sights, sightAlong("against the mean normal", -normal, axes.col(2)));
  }
  const char* const names[] = {"shortest", "middle", "longest"};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      addUnlessAlike(sights, sightAlong(std::string("along the ") + names[axis] + " principal axis",
                                        sign * axes.col(axis), axes.col(axis == 2 ? 1 : 2)));
    }
  }
  return sights;
}

}  // namespace morphgrid
