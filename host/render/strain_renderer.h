#pragma once
#include <Eigen/Geometry>

#include "gpu/offscreen_target.h"
#include "render/grid_painter.h"
#include "render/image.h"

namespace morphgrid {

/// Draws strut grids off screen, on white, from the solver's own buffers.
class StrainRenderer {
 public:
  /// width, height > 0: of the images, in pixels. samples: of a pixel, where the device has them: 1
  /// or 4. Keeps a reference. Throws DeviceError when the device cannot draw such an image.
  StrainRenderer(const Device& device, int width, int height, int samples = 4);

  /// The struts, of a frame as its bars, coloured by strain (shaders/shared/strain_color.h).
  /// worldFromGrid moves the grid
  /// from where it lies, in the scene's unit of length, to where the camera looks. Throws
  /// DeviceError when the device fails or the grid exceeds its limits.
  Image drawStruts(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                   const Camera& camera);

  /// The smooth surface of the middle layer (of an even count: the mean of the middle two), with
  /// isolines along the struts; otherwise as drawStruts().
  Image drawSurface(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                    const Camera& camera);

 private:
  int height() const { return static_cast<int>(target_.size().height); }
  Image draw(const DeviceGrid& grid, const GridLook& look, const Eigen::Isometry3d& worldFromGrid,
             const Camera& camera);

  const Device& device_;
  OffscreenTarget target_;
  GridPainter painter_;
};

}  // namespace morphgrid
