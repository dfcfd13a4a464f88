#include "render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace morphgrid {
namespace {

/// rad, over the picture's shorter side.
constexpr double kFieldOfView = 28 * std::numbers::pi / 180;
constexpr double kFramed = 0.9;  ///< Share of the field of view that the points may fill.

/// Rows: right, up, and towards the eye.
Eigen::Matrix3d rotationFor(const Eigen::Vector3d& viewDirection, const Eigen::Vector3d& up) {
  const Eigen::Vector3d backwards = -viewDirection.normalized();
  Eigen::Vector3d right = up.cross(backwards);
  if (right.norm() < 1e-6 * up.norm() || up.isZero()) {
    right = backwards.unitOrthogonal();
  }
  right.normalize();
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), backwards.cross(right).transpose(), backwards.transpose();
  return rotation;
}

/// How far towards the eye it must be for the points to fit, in one direction of the picture,
/// between two planes of slope `slope` through it.
double fittingDistance(const Eigen::ArrayXd& sideways, const Eigen::ArrayXd& towardsEye,
                       double slope) {
  const double upper = (sideways + slope * towardsEye).maxCoeff();
  const double lower = (slope * towardsEye - sideways).maxCoeff();
  return (upper + lower) / (2 * slope);
}

/// Where the eye sees the outermost points on either side under equal angles. depths > 0.
double centeredEye(const Eigen::ArrayXd& sideways, const Eigen::ArrayXd& depths) {
  // How often the outermost points may change: two or three times are usual.
  constexpr int kMostChanges = 20;
  double eye = sideways.mean();
  for (int change = 0; change < kMostChanges; ++change) {
    Eigen::Index first, last;
    ((sideways - eye) / depths).minCoeff(&first);
    ((sideways - eye) / depths).maxCoeff(&last);
    const double centered = (sideways[first] * depths[last] + sideways[last] * depths[first]) /
                            (depths[first] + depths[last]);
    if (centered == eye) {
      break;
    }
    eye = centered;
  }
  return eye;
}

glm::dmat4 translationThenRotation(const Eigen::Matrix3d& rotation,
                                   const Eigen::Vector3d& eyeInView) {
  glm::dmat4 matrix(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix[column][row] = rotation(row, column);
    }
    matrix[3][row] = -eyeInView[row];
  }
  return matrix;
}

}  // namespace

Camera cameraAt(const Eigen::Vector3d& eye, const Eigen::Matrix3d& viewRotation, double aspect,
                double nearPlane, double farPlane) {
  assert(0 < nearPlane && nearPlane < farPlane);
  Camera camera;
  camera.viewFromWorld = translationThenRotation(viewRotation, viewRotation * eye);
  camera.clipFromView =
      glm::perspectiveRH_ZO(2 * std::atan(viewSlope(aspect)), aspect, nearPlane, farPlane);
  camera.clipFromView[1][1] *= -1;
  return camera;
}

double viewSlope(double aspect) { return std::tan(kFieldOfView / 2) / std::min(aspect, 1.0); }

Camera frameAll(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& viewDirection,
                const Eigen::Vector3d& up, double aspect) {
  assert(points.cols() >= 1 && aspect > 0 && !viewDirection.isZero());
  const Eigen::Matrix3d rotation = rotationFor(viewDirection, up);
  const Eigen::Matrix3Xd inView = rotation * points;
  const Eigen::Vector3d extent = inView.rowwise().maxCoeff() - inView.rowwise().minCoeff();
  const double size = extent.norm() > 0 ? extent.norm() : 1;
  const double farthest = inView.row(2).minCoeff();
  const double nearest = inView.row(2).maxCoeff();

  const double slope = viewSlope(aspect);
  const Eigen::ArrayXd towardsEye = inView.row(2);
  const double fitting =
      std::max(fittingDistance(inView.row(0), towardsEye, kFramed * slope * aspect),
               fittingDistance(inView.row(1), towardsEye, kFramed * slope));
  // Points in a line along the view fit at no distance: keep off them.
  const double distance = std::max(fitting, nearest + size / 4);
  const Eigen::ArrayXd depths = distance - towardsEye;
  const Eigen::Vector3d eye(centeredEye(inView.row(0), depths), centeredEye(inView.row(1), depths),
                            distance);

  // What is drawn around the points (the struts' width) must not be cut off.
  const double nearPlane = (distance - nearest) / 2;
  const double farPlane = distance - farthest + size / 4;
  return cameraAt(rotation.transpose() * eye, rotation, aspect, nearPlane, farPlane);
}

}  // namespace morphgrid
