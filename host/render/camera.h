#pragma once
#include <Eigen/Core>
#include <glm/glm.hpp>

#include "core/view.h"

namespace morphgrid {

/// Where a picture is taken from: a perspective with Vulkan's conventions, depth from 0 (near) to 1
/// (far) and y down. In the view, x is to the right, y up, and z towards the eye.
struct Camera {
  glm::dmat4 viewFromWorld;  ///< A rigid motion.
  glm::dmat4 clipFromView;

  glm::dmat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
  glm::dvec3 eye() const { return glm::dvec3(glm::inverse(viewFromWorld)[3]); }
};

/// A camera at `eye`. viewRotation: orthonormal rows: what points to the right, up, and towards the
/// eye. aspect = width / height of the picture, > 0; 0 < nearPlane < farPlane, distances.
Camera cameraAt(const Eigen::Vector3d& eye, const Eigen::Matrix3d& viewRotation, double aspect,
                double nearPlane, double farPlane);

/// Half of what the camera sees at a distance of 1, upwards.
double viewSlope(double aspect);

/// The nearest camera that looks along viewDirection and sees all points, with a margin, centred.
/// points: 3 x n, n >= 1, in world coordinates. viewDirection: any length but 0; up: what points up
/// in the picture; where it is parallel to viewDirection, some direction is taken. aspect = width /
/// height of the picture, > 0.
Camera frameAll(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& viewDirection,
                const Eigen::Vector3d& up, double aspect);

}  // namespace morphgrid
