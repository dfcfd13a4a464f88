#pragma once
#include <Eigen/Core>
#include <array>

#include "grid/grid_topology.h"

namespace morphgrid {

/// Where a point of a line of `count` points lies among the `otherCount` points of another line
/// over the same length.
double matchingPlace(int index, int count, int otherCount);

/// Interpolation at a place on a line: linear, or cubic where there are four points.
struct LineStencil {
  int first;
  int count;
  std::array<double, 4> weights;
};

LineStencil linearStencil(double place, int pointCount);
/// Lagrange's polynomial through the four nearest points.
LineStencil cubicStencil(double place, int pointCount);

/// visit(i, j, weight): the points of a layer from which a place between them is interpolated.
template <typename Visit>
void forEachWeight(const LineStencil& u, const LineStencil& v, Visit visit) {
  for (int q = 0; q < v.count; ++q) {
    for (int p = 0; p < u.count; ++p) {
      visit(u.first + p, v.first + q, u.weights[p] * v.weights[q]);
    }
  }
}

/// The vertex of another grid of as many layers that lies nearest.
int nearestVertex(const GridShape& from, int vertex, const GridShape& to);

/// Positions, 3 x vertexCount, for a grid of other nodes: the mean of all layers and the layers'
/// offsets from it in cubic interpolation, the offsets scaled.
Eigen::Matrix3Xd resampleLayers(const GridShape& from, const Eigen::Matrix3Xd& positions,
                                const GridShape& to, double offsetScale);

}  // namespace morphgrid
