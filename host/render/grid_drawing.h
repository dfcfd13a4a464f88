#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "gpu/resource_set.h"
#include "render/local_view.h"
#include "shared/render_types.h"
#include "solve/device_grid.h"

namespace morphgrid {

/// What pictures of struts and of surfaces have in common.

/// Views of buffers that hold an ivec4 a vertex, as positions and rest lengths do; printed: of a
/// frame.
TexelView texelsOf(const Device& device, const Buffer& buffer);
TexelView positionTexels(const Device& device, const DeviceGrid& grid);
TexelView restTexels(const Device& device, const DeviceGrid& grid);
TexelView printedTexels(const Device& device, const DeviceGrid& grid);
TexelView stiffnessTexels(const Device& device, const DeviceGrid& grid);

/// worldFromGrid moves the grid from where it lies, in the scene's unit of length, to where the
/// camera looks.
LocalView viewOf(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                 const Camera& camera, int imageHeight);

/// For the struts to +u, +v or +w (0, 1, 2). Bars are as wide and high as their sections.
StrutPush strutPush(const DeviceGrid& grid, const LocalView& view, int direction);

/// The surface is refined up to about as many quads as look smooth. mostQuads: it is drawn with
/// about as many at most, through fewer vertices than there are if need be.
SurfacePush surfacePush(const DeviceGrid& grid, const LocalView& view,
                        std::optional<int> mostQuads = std::nullopt);

uint surfaceVertexCount(const SurfacePush& push);

}  // namespace morphgrid
