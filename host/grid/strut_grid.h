#pragma once
#include <Eigen/Core>
#include <vector>

namespace morphgrid {

/// How many vertices a grid has; a node is a cell between them.
struct GridShape {
  int verticesU;
  int verticesV;
  int layers;

  int layerVertexCount() const { return verticesU * verticesV; }
  int vertexCount() const { return layerVertexCount() * layers; }
  int index(int i, int j, int k) const { return (k * verticesV + j) * verticesU + i; }
  int lateralStrutCount() const {
    return layers * ((verticesU - 1) * verticesV + verticesU * (verticesV - 1));
  }
  int strutCount() const { return lateralStrutCount() + (layers - 1) * layerVertexCount(); }
  bool operator==(const GridShape&) const = default;
};

/// One value per strut, stored at the vertex that the strut leaves in the +u, +v or +w direction;
/// 0 where there is no such strut.
struct StrutValues {
  std::vector<double> u, v, w;

  StrutValues() = default;
  explicit StrutValues(const GridShape& shape)
      : u(shape.vertexCount()), v(shape.vertexCount()), w(shape.vertexCount()) {}
};

/// A strut of the implicit topology.
struct Strut {
  enum class Direction { u, v, w };
  int from;
  int to;
  Direction direction;
  int layer;
};

/// A morphing problem: find the positions of least energy, starting from `positions`.
struct StrutGrid {
  GridShape shape;
  double spacing;              ///< Length of a cell of the printed sheet, > 0: the natural unit.
  Eigen::Matrix3Xd positions;  ///< Where the stage starts, in the scene's unit of length.
  StrutValues rest;            ///< Rest lengths L, > 0 where there is a strut.
  StrutValues stiffness;       ///< w c of `w c (|e| - L)^2`, > 0 where there is a strut.
  double angleWeight;          ///< w of every corner, >= 0.
};

/// All struts, u before v before w at each vertex, vertices in index order.
std::vector<Strut> listStruts(const GridShape& shape);

double valueAt(const StrutValues& values, const Strut& strut);
double& valueAt(StrutValues& values, const Strut& strut);

/// Throws InputError when sizes do not fit together, a number is not finite, a rest length or
/// stiffness of a strut is not positive, or neighbours start at the same place.
void validate(const StrutGrid& grid);

/// A layer of shape.verticesU x verticesV vertices whose struts rest where they are: makes a target
/// something that is drawn like a result. points: one column a vertex; spacing as of StrutGrid.
StrutGrid layerAtRest(const GridShape& shape, double spacing, const Eigen::Matrix3Xd& points);

/// The layer that stands for the surface: the middle one, or the mean of the middle two.
/// Returns layerVertexCount columns.
Eigen::Matrix3Xd middleLayer(const GridShape& shape, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
