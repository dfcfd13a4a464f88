#pragma once
#include <Eigen/Geometry>

#include "gpu/offscreen_target.h"
#include "render/grid_painter.h"
#include "render/image.h"

namespace morphgrid {

/// A grid, and the motion from where it lies to where the camera looks.
struct PlacedGrid {
  const DeviceGrid& grid;
  Eigen::Isometry3d worldFromGrid;
};

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

  /// Lateral struts, each in the colour of its share (shaders/shared/share_color.h). The camera
  /// looks where the grid lies. Errors as those of drawStruts().
  Image drawStrutShares(const DeviceGrid& grid, const StrutValues& shares, const Camera& camera);

  /// The smooth surface of the middle layer in colours of shares, with the veil's over it,
  /// translucent. shares: of the vertices of a layer, in index order; linear between them.
  Image drawSurfaceShares(const PlacedGrid& surface, const Eigen::VectorXd& shares,
                          const PlacedGrid& veil, const Camera& camera);

 private:
  int height() const { return static_cast<int>(target_.size().height); }
  Image picture(const std::function<void(const CommandBuffer&)>& draw);
  Image draw(const DeviceGrid& grid, const GridLook& look, const Eigen::Isometry3d& worldFromGrid,
             const Camera& camera);

  const Device& device_;
  OffscreenTarget target_;
  GridPainter painter_;
};

}  // namespace morphgrid
