#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// An implicit torso of our own making, cut at neck, arms and thighs: about the signed distance to
/// its skin, in cm, negative inside, smooth. x runs sideways, y up from the hips, z to the front.
/// Mirrored about x = 0.
double torsoField(const Eigen::Vector3d& point);

}  // namespace morphgrid
