#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "grid/strut_grid.h"

namespace morphgrid {

/// Where grids lie: as they are.
inline const Eigen::Isometry3d kUnmoved = Eigen::Isometry3d::Identity();

/// A grid whose vertices lie at `pointAt(i, j, k)`, all struts strained by `strain`.
StrutGrid gridThrough(const GridShape& shape,
                      const std::function<Eigen::Vector3d(int i, int j, int k)>& pointAt,
                      double strain = 0);

/// Square cells of side `spacing` in the plane z = 0, from the origin; layers 0.3 spacings apart.
StrutGrid flatGrid(const GridShape& shape, double spacing = 1, double strain = 0);

/// A saddle of cells of side 1, whose rest lengths are those of the flat grid.
StrutGrid saddleGrid(const GridShape& shape);

}  // namespace morphgrid
