#include "surface/join_vertices.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace morphgrid {
namespace {

using Cell = std::array<std::int32_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int32_t index : cell) {
      hash = (hash ^ static_cast<std::uint32_t>(index)) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

/// Points so far, none of them near another. Cells are four distances wide: what is near a point
/// mostly lies in one of them, and none holds more than fit into it.
class SparsePoints {
 public:
  explicit SparsePoints(double distance) : distance_(distance) {}

  /// The index of the point that is near, the first there was; the point itself is added where
  /// there is none.
  int indexOf(const Eigen::Vector3d& point) {
    const Cell low = cellOf(point.array() - distance_);
    const Cell high = cellOf(point.array() + distance_);
    for (std::int32_t x = low[0]; x <= high[0]; ++x) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        for (std::int32_t z = low[2]; z <= high[2]; ++z) {
          if (const int near = findIn({x, y, z}, point); near >= 0) return near;
        }
      }
    }
    cells_[cellOf(point)].push_back(static_cast<int>(points_.size()));
    points_.push_back(point);
    return static_cast<int>(points_.size()) - 1;
  }

 private:
  Cell cellOf(const Eigen::Array3d& point) const {
    const Eigen::Array3d place = (point / (4 * distance_)).floor();
    return {static_cast<std::int32_t>(place[0]), static_cast<std::int32_t>(place[1]),
            static_cast<std::int32_t>(place[2])};
  }

  int findIn(const Cell& cell, const Eigen::Vector3d& point) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return -1;
    for (const int index : found->second) {
      if ((points_[index] - point).cwiseAbs().maxCoeff() <= distance_) return index;
    }
    return -1;
  }

  double distance_;
  std::vector<Eigen::Vector3d> points_;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

}  // namespace

TriangleMesh joinVertices(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  // In halves, lest the largest coordinates overflow: the box then measures 1 at most.
  const Eigen::Vector3d middle = box.min() / 2 + box.max() / 2;
  const double size = 2 * (box.max() / 2 - box.min() / 2).maxCoeff();
  const double unit = std::isfinite(size) && size > 0 ? size : std::numeric_limits<double>::max();
  SparsePoints points(kRoundingOfVertices);
  TriangleMesh joined{{}, mesh.triangles};
  std::vector<int> newIndices(mesh.vertices.cols(), -1);
  std::vector<int> kept;
  for (int& corner : joined.triangles.reshaped()) {
    int& index = newIndices[corner];
    if (index < 0) {
      index = points.indexOf((mesh.vertices.col(corner) - middle) / unit);
      if (index == static_cast<int>(kept.size())) kept.push_back(corner);
    }
    corner = index;
  }
  joined.vertices = mesh.vertices(Eigen::all, kept);
  return joined;
}

}  // namespace morphgrid
