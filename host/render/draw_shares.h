#pragma once
#include <Eigen/Geometry>

#include "grid/strut_grid.h"
#include "render/camera.h"
#include "render/image.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// Off screen, on white, in colours of shares (shaders/shared/share_color.h). width, height > 0: of
/// the image, in pixels. samples: as of StrainRenderer. All throw DeviceError when the device fails
/// or a grid exceeds its limits.

/// Lateral struts, each in the colour of its share. The camera looks where the grid lies.
Image drawStrutShares(const Device& device, const DeviceGrid& grid, const StrutValues& shares,
                      const Camera& camera, int width, int height, int samples = 4);

/// A grid, and the motion from where it lies to where the camera looks.
struct PlacedGrid {
  const DeviceGrid& grid;
  Eigen::Isometry3d worldFromGrid;
};

/// The smooth surface of the middle layer, with the veil's over it, translucent. shares: of the
/// vertices of a layer, in index order; linear between them.
Image drawSurfaceShares(const Device& device, const PlacedGrid& surface,
                        const Eigen::VectorXd& shares, const PlacedGrid& veil, const Camera& camera,
                        int width, int height, int samples = 4);

}  // namespace morphgrid
