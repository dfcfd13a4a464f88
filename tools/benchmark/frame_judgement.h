#pragma once
#include <Eigen/Core>

#include "design/material.h"
#include "gpu/device.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Percent of the diagonal of the targets, see ShapeError.
struct ShapePercent {
  double rms = 0;
  double max = 0;
};

/// Where a printed design ends when its bars are welded, whatever model it was made in: morphed
/// from the flat sheet.
struct FrameJudgement {
  ShapePercent asDesigned;
  Eigen::Matrix3Xd middle;  ///< 3 x layerVertexCount: where its middle layer comes to rest.
  ShapePercent inexact;     ///< Rest lengths off at random, by 2 % (normally distributed).
  ShapePercent thicker;     ///< Bars and posts 25 % thicker than they were designed for.
};

/// grid: as printed, with its final rest lengths, of any model; targets: 3 x layerVertexCount;
/// bars: their sizes. Throws DeviceError when the device fails.
FrameJudgement judgeAsFrame(const Device& device, const StrutGrid& grid,
                            const Eigen::Matrix3Xd& targets, MaterialRequest bars);

}  // namespace morphgrid
