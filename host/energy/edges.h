#pragma once
#include <Eigen/Core>
#include <array>

#include "grid/strut_grid.h"
#include "shared/energy_constants.h"

namespace morphgrid {

/// An edge of the grid, by the vertices at its ends.
struct Edge {
  int from;
  int to;
};

/// The edges on which a term of the energy depends.
template <int count>
using EdgeStencil = std::array<Edge, count>;

/// A vector for each edge of a stencil, one column each: the edges themselves, how they change, or
/// a gradient by them.
template <int count>
using EdgeVectors = Eigen::Matrix<double, 3, count>;

/// What a term is at given edges.
template <int count>
struct TermValue {
  double energy;
  EdgeVectors<count> gradient;  ///< Derivative by each edge, a column each.
};

/// kLeastSquare in the grid's unit of length, squared.
inline double leastSquareOf(const StrutGrid& grid) {
  return double{kLeastSquare} * grid.spacing * grid.spacing;
}

/// For each edge the vector at its end less that at its start. vectors: 3 x vertexCount; positions
/// give the edges, motions how the edges change.
template <std::size_t count>
EdgeVectors<count> differencesAlong(const std::array<Edge, count>& stencil,
                                    const Eigen::Matrix3Xd& vectors) {
  EdgeVectors<count> differences;
  for (std::size_t n = 0; n < count; ++n) {
    differences.col(n) = vectors.col(stencil[n].to) - vectors.col(stencil[n].from);
  }
  return differences;
}

/// The transposed of differencesAlong(): adds a gradient by edges to byVertices, one by vertices,
/// 3 x vertexCount.
template <std::size_t count>
void addToEnds(const std::array<Edge, count>& stencil,
               const Eigen::Matrix<double, 3, static_cast<int>(count)>& gradient,
               Eigen::Matrix3Xd& byVertices) {
  for (std::size_t n = 0; n < count; ++n) {
    byVertices.col(stencil[n].to) += gradient.col(n);
    byVertices.col(stencil[n].from) -= gradient.col(n);
  }
}

}  // namespace morphgrid
