#include "render/thinned_lattice.h"

#include <algorithm>
#include <cassert>

#include "grid/strain.h"

namespace morphgrid {

ThinnedLattice::ThinnedLattice(const GridShape& shape, int mostCells)
    : shape_(shape),
      stride_((std::max(shape.cellsU(), shape.cellsV()) + mostCells - 1) / mostCells) {
  assert(mostCells >= 1);
}

GridShape ThinnedLattice::shapeOf(int layers) const {
  const ivec2 size = thinnedSize({shape_.verticesU, shape_.verticesV}, stride_);
  return {size.x, size.y, layers};
}

template <typename Visit>
void ThinnedLattice::forEachColumn(int layers, const Visit& visit) const {
  const GridShape drawn = shapeOf(layers);
  forEachVertex(drawn, [&](const GridPlace& place) {
    const ivec2 column =
        thinnedPoint({shape_.verticesU, shape_.verticesV}, stride_, {place.i, place.j});
    visit(drawn.index(place), shape_.index(column.x, column.y, place.layer));
  });
}

Eigen::Matrix3Xd ThinnedLattice::points(const Eigen::Matrix3Xd& all) const {
  const auto layers = static_cast<int>(all.cols() / shape_.layerVertexCount());
  Eigen::Matrix3Xd drawn(3, shapeOf(layers).vertexCount());
  forEachColumn(layers, [&](int to, int from) { drawn.col(to) = all.col(from); });
  return drawn;
}

StrutValues ThinnedLattice::values(const StrutValues& all) const {
  StrutValues drawn(shapeOf(shape_.layers));
  forEachColumn(shape_.layers, [&](int to, int from) {
    drawn.u[to] = all.u[from];
    drawn.v[to] = all.v[from];
    drawn.w[to] = all.w[from];
  });
  return drawn;
}

StrutGrid ThinnedLattice::grid(const StrutGrid& all, const Eigen::Matrix3Xd& positions) const {
  assert(!all.bars && all.shape == shape_);
  StrutValues strains(all.shape);
  forEachStrut(all.shape, [&](const Strut& strut) {
    valueAt(strains, strut) = strainAt(all, positions, strut);
  });
  StrutGrid drawn{.shape = shapeOf(all.shape.layers),
                  .spacing = stride_ * all.spacing,
                  .positions = points(positions),
                  .rest = values(strains),
                  .stiffness = values(all.stiffness),
                  .weights = all.weights};
  forEachStrut(drawn.shape, [&](const Strut& strut) {
    double& rest = valueAt(drawn.rest, strut);
    rest = lengthAt(drawn.positions, strut) / (1 + rest);
  });
  return drawn;
}

}  // namespace morphgrid
