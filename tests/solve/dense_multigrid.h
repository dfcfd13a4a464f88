#pragma once
#include <Eigen/Core>
#include <vector>

#include "solve/coarse_levels.h"

namespace morphgrid {

/// Interpolation from columns to vertices, 3 vertexCount x 6 columns: u(x) = t + w x (x - centre),
/// the centre in layer layers / 2. positions: 3 x vertexCount.
Eigen::MatrixXd denseColumnProlongation(const GridShape& shape, const Eigen::Matrix3Xd& positions);

/// Linked interpolation from the next coarser level, 6 points x 6 coarsened(points).
/// centres: of the finer level, 3 x points.
Eigen::MatrixXd densePointProlongation(PointGrid points, const Eigen::Matrix3Xd& centres);

/// The centres that a coarser level keeps.
Eigen::Matrix3Xd keptCentres(PointGrid points, const Eigen::Matrix3Xd& centres);

/// u(x) = t + w x x for all points, motion = (t, w): 6 numbers a point.
Eigen::VectorXd rigidMotion(const Eigen::Matrix3Xd& centres,
                            const Eigen::Matrix<double, 6, 1>& motion);

/// What the device holds of a level, 6 points square.
Eigen::MatrixXd downloadMatrix(const Device& device, const PointLevel& level);
Eigen::MatrixXd downloadInverse(const Device& device, const PointLevel& level);

/// Six numbers a point.
Eigen::VectorXd downloadMotions(const Device& device, const TexelBuffer& motions);
void uploadMotions(const Device& device, const TexelBuffer& motions, const Eigen::VectorXd& values);

}  // namespace morphgrid
