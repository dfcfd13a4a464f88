#include "render/grid_drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "shared/solver_types.h"

namespace morphgrid {
namespace {

constexpr double kStrutHalfWidth = 0.042;    // Spacings.
constexpr double kLargestHalfWidth = 0.012;  // Of the grid's longer side: few cells stay slender.
constexpr int kMostSurfaceQuads = 30000;     // The surface is refined up to about this many.
constexpr int kFinestRefinement = 16;
constexpr int kMostIsolines = 50;  // Along u, and along v.

TexelView texelsOf(const Device& device, const Buffer& buffer) {
  return {device, buffer, vk::Format::eR32G32B32A32Sint, sizeof(ivec4)};
}

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

int chooseRefinement(const GridShape& shape) {
  const double cells = static_cast<double>(shape.verticesU - 1) * (shape.verticesV - 1);
  return std::clamp(static_cast<int>(std::sqrt(kMostSurfaceQuads / cells)), 1, kFinestRefinement);
}

}  // namespace

TexelView positionTexels(const Device& device, const DeviceGrid& grid) {
  return texelsOf(device, grid.positions());
}

TexelView restTexels(const Device& device, const DeviceGrid& grid) {
  return texelsOf(device, grid.rest());
}

LocalView viewOf(const DeviceGrid& grid, const Eigen::Isometry3d& worldFromGrid,
                 const Camera& camera, int imageHeight) {
  return localView(worldFromLocal(grid, worldFromGrid), camera, imageHeight);
}

StrutPush strutPush(const DeviceGrid& grid, const LocalView& view) {
  const GridShape& shape = grid.shape();
  StrutPush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.halfWidth = static_cast<float>(chooseHalfWidth(shape));
  push.towardsLight = view.towardsLight;
  push.resolution = static_cast<float>(grid.resolution());
  push.verticesU = shape.verticesU;
  push.verticesV = shape.verticesV;
  push.layers = shape.layers;
  push.restResolution = static_cast<float>(grid.restResolution());
  push.pixelSize = view.pixelSize;
  return push;
}

std::array<int, 3> strutCounts(const GridShape& shape) {
  return {(shape.verticesU - 1) * shape.verticesV * shape.layers,
          shape.verticesU * (shape.verticesV - 1) * shape.layers,
          shape.layerVertexCount() * (shape.layers - 1)};
}

SurfacePush surfacePush(const DeviceGrid& grid, const LocalView& view) {
  const GridShape& shape = grid.shape();
  SurfacePush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.resolution = static_cast<float>(grid.resolution());
  push.towardsLight = view.towardsLight;
  push.refine = chooseRefinement(shape);
  push.verticesU = shape.verticesU;
  push.verticesV = shape.verticesV;
  push.layers = shape.layers;
  push.isolineStride = 1 + std::max(shape.verticesU, shape.verticesV) / kMostIsolines;
  return push;
}

uint surfaceVertexCount(const SurfacePush& push) {
  const int quads = (push.verticesU - 1) * (push.verticesV - 1) * push.refine * push.refine;
  return kVerticesPerQuad * static_cast<uint>(quads);
}

}  // namespace morphgrid
