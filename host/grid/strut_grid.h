#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "grid/bars.h"
#include "grid/grid_topology.h"
#include "grid/term_weights.h"

namespace morphgrid {

/// One value per strut, stored at the index of the vertex that the strut leaves in the +u, +v or +w
/// direction; each vector has vertexCount values, 0 where there is no such strut.
struct StrutValues {
  std::vector<double> u, v, w;

  StrutValues() = default;
  explicit StrutValues(const GridShape& shape)
      : u(shape.vertexCount()), v(shape.vertexCount()), w(shape.vertexCount()) {}
};

/// A morphing problem: find the positions of least energy, starting from `positions`.
struct StrutGrid {
  GridShape shape;
  double spacing;              ///< Length of a cell of the printed sheet, > 0: the natural unit.
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount, where the stage starts; the scene's unit.
  StrutValues rest;            ///< Rest lengths L, > 0 where there is a strut.
  StrutValues stiffness;       ///< w c of `w c (|e| - L)^2`, > 0 where there is a strut.
  TermWeights weights;         ///< All >= 0.
  /// Its struts as welded bars: then vertices are joints that turn, and stiffness and weights are
  /// of no account.
  std::optional<Bars> bars = std::nullopt;
  /// 3 x vertexCount, positions as printed: then corners in a layer rest at the angles that they
  /// have there, else at 90 degrees. Not beside bars, which have their own.
  std::optional<Eigen::Matrix3Xd> printedCorners = std::nullopt;
};

/// What its struts are: that decides which kernels solve it.
enum class Mechanics { springs, springsAsPrinted, frame };

inline Mechanics mechanicsOf(const StrutGrid& grid) {
  if (grid.bars) return Mechanics::frame;
  return grid.printedCorners ? Mechanics::springsAsPrinted : Mechanics::springs;
}

/// The value of a strut of the grid that the values belong to.
template <typename Values>  // StrutValues or const StrutValues
auto& valueAt(Values& values, const Strut& strut) {
  using enum Strut::Direction;
  auto& along = strut.direction == u ? values.u : strut.direction == v ? values.v : values.w;
  return along[strut.from];
}

/// The distance of a strut's ends. positions: 3 x vertexCount.
inline double lengthAt(const Eigen::Matrix3Xd& positions, const Strut& strut) {
  return (positions.col(strut.to) - positions.col(strut.from)).norm();
}

/// The columns of layer k of a matrix with one column a vertex.
template <typename Matrix>  // Eigen::Matrix3Xd or const Eigen::Matrix3Xd
auto layerOf(const GridShape& shape, Matrix& vertices, int k) {
  return vertices.middleCols(shape.index(0, k), shape.layerVertexCount());
}

/// The rigid motions that nothing holds: along x, y, z are 0 to 2, about them 3 to 5.
std::vector<int> freeMotions(const StrutGrid& grid);

/// Throws InputError when sizes do not fit together, a number is not finite, a rest length or
/// stiffness of a strut is not positive, or neighbours start at the same place.
void validate(const StrutGrid& grid);

/// A layer of shape.verticesU x verticesV vertices whose struts rest where they are: makes a target
/// something that is drawn like a result. points: 3 x layerVertexCount; spacing: see StrutGrid.
StrutGrid layerAtRest(const GridShape& shape, double spacing, const Eigen::Matrix3Xd& points);

/// The layer that stands for the surface: the middle one, or the mean of the middle two. positions:
/// 3 x vertexCount; returns 3 x layerVertexCount.
Eigen::Matrix3Xd middleLayer(const GridShape& shape, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
