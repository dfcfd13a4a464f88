#include "render/grid_drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "grid/bar_section.h"

namespace morphgrid {
namespace {

constexpr double kStrutHalfWidth = 0.042;  // Spacings.
// Share of the grid's longer side: struts of few cells stay slender.
constexpr double kLargestHalfWidth = 0.012;
constexpr int kSmoothQuads = 8000;  // The surface is refined up to about this many.
constexpr int kFinestRefinement = 16;
constexpr int kMostIsolines = 50;  // Along u, and along v.

/// Local coordinates: spacings about the grid's fixed-point zero.
glm::dmat4 worldFromLocal(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid) {
  const Eigen::Matrix4d& rigid = worldFromGrid.matrix();
  const Eigen::Vector3d& origin = grid.origin();
  const glm::dmat4 moved =
      glm::translate(glm::make_mat4(rigid.data()), {origin.x(), origin.y(), origin.z()});
  return glm::scale(moved, glm::dvec3(grid.spacing()));
}

double chooseHalfWidth(const GridShape& shape) {
  const double longerSide = std::max(shape.verticesU, shape.verticesV) - 1;
  return std::min(kStrutHalfWidth, kLargestHalfWidth * longerSide);
}

struct HalfSize {
  double width, height;
};

/// Of a strut, in spacings.
HalfSize halfSizeOf(const DeviceGrid& grid, int direction) {
  if (!grid.isFrame()) {
    const double half = chooseHalfWidth(grid.shape());
    return {half, half};
  }
  const DeviceFrame& frame = grid.frame();
  const DeviceBarSection& section = direction == 2 ? frame.upright : frame.lateral;
  return {rectangleSide(section.stretching, section.bendingN) / 2,
          rectangleSide(section.stretching, section.bendingB) / 2};
}

double cellCount(const GridShape& shape) {
  return static_cast<double>(shape.verticesU - 1) * (shape.verticesV - 1);
}

int chooseRefinement(const GridShape& shape, int mostQuads) {
  return std::clamp(static_cast<int>(std::sqrt(mostQuads / cellCount(shape))), 1,
                    kFinestRefinement);
}

}  // namespace

TexelView texelsOf(const Device& device, const Buffer& buffer) {
  return {device, buffer, TexelFormat::int4};
}

TexelView positionTexels(const Device& device, const DeviceGrid& grid) {
  return texelsOf(device, grid.positions());
}

TexelView restTexels(const Device& device, const DeviceGrid& grid) {
  return texelsOf(device, grid.rest());
}

TexelView stiffnessTexels(const Device& device, const DeviceGrid& grid) {
  return {device, grid.stiffness(), TexelFormat::float4};
}

TexelView printedTexels(const Device& device, const DeviceGrid& grid) {
  return {device, grid.printed(), TexelFormat::float4};
}

LocalView viewOf(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                 const Camera& camera, int imageHeight) {
  return localView(worldFromLocal(grid, worldFromGrid), camera, imageHeight);
}

StrutPush strutPush(const DeviceGrid& grid, const LocalView& view, int direction) {
  const HalfSize half = halfSizeOf(grid, direction);
  StrutPush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.halfWidth = static_cast<float>(half.width);
  push.towardsLight = view.towardsLight;
  push.resolution = static_cast<float>(grid.resolution());
  push.size = sizeOf(grid.shape());
  push.direction = direction;
  push.restResolution = static_cast<float>(grid.restResolution());
  push.pixelSize = view.pixelSize;
  push.stride = 1;
  push.halfHeight = static_cast<float>(half.height);
  return push;
}

SurfacePush surfacePush(const DeviceGrid& grid, const LocalView& view,
                        std::optional<int> mostQuads) {
  const GridShape& shape = grid.shape();
  SurfacePush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.resolution = static_cast<float>(grid.resolution());
  push.towardsLight = view.towardsLight;
  push.stride =
      mostQuads ? static_cast<int>(std::ceil(std::sqrt(cellCount(shape) / *mostQuads))) : 1;
  push.size = sizeOf(shape);
  push.drawnSize = thinnedSize(push.size, push.stride);
  push.refine =
      chooseRefinement({push.drawnSize.x, push.drawnSize.y, 1}, mostQuads.value_or(kSmoothQuads));
  push.isolineStride = 1 + std::max(push.drawnSize.x, push.drawnSize.y) / kMostIsolines;
  return push;
}

uint surfaceVertexCount(const SurfacePush& push) {
  const int quads = (push.drawnSize.x - 1) * (push.drawnSize.y - 1) * push.refine * push.refine;
  return kVerticesPerQuad * static_cast<uint>(quads);
}

}  // namespace morphgrid
