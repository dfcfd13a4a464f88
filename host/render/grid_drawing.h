#pragma once
#include <Eigen/Geometry>
#include <array>

#include "gpu/resource_set.h"
#include "render/local_view.h"
#include "shared/render_types.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// What pictures of struts and of surfaces have in common.

TexelView positionTexels(const Device& device, const DeviceGrid& grid);
TexelView restTexels(const Device& device, const DeviceGrid& grid);

/// worldFromGrid moves the grid from where it lies, in the scene's unit of length, to where the
/// camera looks.
LocalView viewOf(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                 const Camera& camera, int imageHeight);

/// For the struts to +u; for others set `direction`.
StrutPush strutPush(const DeviceGrid& grid, const LocalView& view);

/// Struts to +u, +v, +w.
std::array<int, 3> strutCounts(const GridShape& shape);

SurfacePush surfacePush(const DeviceGrid& grid, const LocalView& view);

uint surfaceVertexCount(const SurfacePush& push);

}  // namespace morphgrid
