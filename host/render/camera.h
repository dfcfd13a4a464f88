#pragma once
#include <Eigen/Core>
#include <glm/glm.hpp>

namespace morphgrid {

/// Where a picture is taken from: a perspective with Vulkan's conventions, depth from 0 (near) to 1
/// (far) and y down. In the view, x is to the right, y up, and z towards the eye.
struct Camera {
  glm::dmat4 viewFromWorld;  ///< A rigid motion.
  glm::dmat4 clipFromView;

  glm::dmat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
  glm::dvec3 eye() const { return glm::dvec3(glm::inverse(viewFromWorld)[3]); }
};

/// From the front, a little from the left and from above: shows a grid that was printed flat in z =
/// 0 and bends towards +z.
inline const Eigen::Vector3d kObliqueViewDirection(0.5, 0.85, -0.75);
inline const Eigen::Vector3d kUpwards(0, 0, 1);

/// A direction to look along and what points up in the picture, as frameAll() takes them.
struct View {
  Eigen::Vector3d direction;
  Eigen::Vector3d up;
};

/// For results whose target is a patch, printed in z = 0 and bent towards +z.
inline const View kPatchView{kObliqueViewDirection, kUpwards};
/// For what is flat: from straight above, y up.
inline const View kTopView{{0, 0, -1}, {0, 1, 0}};
/// What rays along +x see of a mesh, y up.
inline const View kRayView{{1, 0, 0}, {0, 1, 0}};
/// For results whose target is a mesh: from where the rays come, a little from above and the left.
inline const View kMeshView{{0.85, -0.3, 0.5}, {0, 1, 0}};

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
