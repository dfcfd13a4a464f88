#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// From the front, a little from the left and from above: shows a grid that was printed flat in z =
/// 0 and bends towards +z.
inline const Eigen::Vector3d kObliqueViewDirection(0.5, 0.85, -0.75);
inline const Eigen::Vector3d kUpwards(0, 0, 1);

/// A direction to look along and what points up in the picture, as frameAll() takes them.
struct View {
  Eigen::Vector3d direction;
  Eigen::Vector3d up;
};

/// For what was printed in z = 0 and bent towards +z.
inline const View kPatchView{kObliqueViewDirection, kUpwards};
/// For what is flat: from straight above, y up.
inline const View kTopView{{0, 0, -1}, {0, 1, 0}};
/// What rays along +x see of a mesh, y up.
inline const View kRayView{{1, 0, 0}, {0, 1, 0}};
/// For results whose target is a mesh: from where the rays come, a little from above and the left.
inline const View kMeshView{{0.85, -0.3, 0.5}, {0, 1, 0}};

}  // namespace morphgrid
