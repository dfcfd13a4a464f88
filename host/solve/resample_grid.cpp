#include "solve/resample_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

int nearestPlace(int index, int count, int otherCount) {
  return static_cast<int>(std::lround(matchingPlace(index, count, otherCount)));
}

std::vector<LineStencil> cubicStencils(int count, int fromCount) {
  std::vector<LineStencil> stencils;
  for (int i = 0; i < count; ++i) {
    stencils.push_back(cubicStencil(matchingPlace(i, count, fromCount), fromCount));
  }
  return stencils;
}

/// One value per vertex of a layer, or one per vertex of a coarser or finer one: columns.
Matrix3Xd resample(const GridShape& from, const Matrix3Xd& points, const GridShape& to) {
  const std::vector<LineStencil> alongU = cubicStencils(to.verticesU, from.verticesU);
  const std::vector<LineStencil> alongV = cubicStencils(to.verticesV, from.verticesV);
  Matrix3Xd result = Matrix3Xd::Zero(3, to.layerVertexCount());
  forEachVertex(to.layer(), [&](const GridPlace& place) {
    forEachWeight(alongU[place.i], alongV[place.j], [&](int i, int j, double weight) {
      result.col(to.index(place)) += weight * points.col(from.index(i, j, 0));
    });
  });
  return result;
}

}  // namespace

double matchingPlace(int index, int count, int otherCount) {
  return count > 1 ? double(index) * (otherCount - 1) / (count - 1) : 0;
}

LineStencil linearStencil(double place, int pointCount) {
  if (pointCount < 2) {
    return {0, 1, {1}};
  }
  const int first = std::min(static_cast<int>(place), pointCount - 2);
  return {first, 2, {1 - (place - first), place - first}};
}

LineStencil cubicStencil(double place, int pointCount) {
  if (pointCount < 4) {
    return linearStencil(place, pointCount);
  }
  LineStencil stencil{std::clamp(static_cast<int>(place) - 1, 0, pointCount - 4), 4, {1, 1, 1, 1}};
  for (int p = 0; p < 4; ++p) {
    for (int q = 0; q < 4; ++q) {
      if (q != p) {
        stencil.weights[p] *= (place - stencil.first - q) / (p - q);
      }
    }
  }
  return stencil;
}

int nearestVertex(const GridShape& from, int vertex, const GridShape& to) {
  const GridPlace place = from.place(vertex);
  return to.index(nearestPlace(place.i, from.verticesU, to.verticesU),
                  nearestPlace(place.j, from.verticesV, to.verticesV), place.layer);
}

Matrix3Xd resampleLayers(const GridShape& from, const Matrix3Xd& positions, const GridShape& to,
                         double offsetScale) {
  Matrix3Xd mean = Matrix3Xd::Zero(3, from.layerVertexCount());
  for (int k = 0; k < from.layers; ++k) {
    mean += layerOf(from, positions, k) / from.layers;
  }
  const Matrix3Xd newMean = resample(from, mean, to);
  Matrix3Xd result(3, to.vertexCount());
  for (int k = 0; k < to.layers; ++k) {
    layerOf(to, result, k) =
        newMean + offsetScale * resample(from, layerOf(from, positions, k) - mean, to);
  }
  return result;
}

}  // namespace morphgrid
