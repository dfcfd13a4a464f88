#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// Every n-th column of a grid along u and v, and the last: what a picture shows of a grid whose
/// cells are hardly larger than its pixels.
class ThinnedLattice {
 public:
  /// n is the least that leaves at most so many cells along u and v (and one more where the last
  /// is narrower), >= 1.
  ThinnedLattice(const GridShape& shape, int mostCells);

  bool isWhole() const { return stride_ == 1; }

  /// all: 3 columns a vertex of one layer or several.
  Eigen::Matrix3Xd points(const Eigen::Matrix3Xd& all) const;
  /// Those of the first struts that the drawn ones stand for.
  StrutValues values(const StrutValues& all) const;
  /// A grid without bars where it lies: each strut as strained as the first that it stands for.
  /// positions: 3 x vertexCount of `all`.
  StrutGrid grid(const StrutGrid& all, const Eigen::Matrix3Xd& positions) const;

 private:
  GridShape shapeOf(int layers) const;
  /// visit(drawn vertex, vertex of the whole grid), in the drawn ones' order.
  template <typename Visit>
  void forEachColumn(int layers, const Visit& visit) const;

  GridShape shape_;
  int stride_;
};

}  // namespace morphgrid
