#include "surface/polygon_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "surface/mesh_source.h"

namespace morphgrid {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Clips ears off a polygon ("Triangulation by Ear Clipping", Eberly), seen along its normal. What
/// has no ear, for it crosses itself or is flat as a line, is clipped at any corner: the result
/// uses every corner all the same.
class EarClipping {
 public:
  explicit EarClipping(const Eigen::Matrix3Xd& points)
      : points_(flattened(points)), left_(points.cols()) {
    std::iota(left_.begin(), left_.end(), 0);
    if (points.cols() == 4) first_ = isFirstDiagonalShorter(points) ? 1 : 0;
  }

  /// Triangles of corners 0 .. n - 1.
  std::vector<Eigen::Vector3i> triangles() {
    std::vector<Eigen::Vector3i> result;
    int corner = first_;
    while (left_.size() > 3) {
      corner = findEar(corner);
      result.push_back(triangleAt(corner));
      left_.erase(left_.begin() + corner);
      corner %= left_.size();
    }
    result.push_back(triangleAt(1));
    return result;
  }

 private:
  /// Projects along Newell's normal, taken with respect to a corner so that a far polygon loses no
  /// digits.
  static Eigen::Matrix2Xd flattened(const Eigen::Matrix3Xd& points) {
    const Eigen::Matrix3Xd arms = points.colwise() - points.col(0).eval();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 1; i < arms.cols(); ++i) normal += arms.col(i - 1).cross(arms.col(i));
    const Eigen::Vector3d u = normal.unitOrthogonal();
    Eigen::Matrix<double, 2, 3> plane;
    plane << u.transpose(), normal.cross(u).stableNormalized().transpose();
    return plane * arms;
  }

  /// A quad's diagonal 0-2 cuts corner 1 off, 1-3 corner 0.
  static bool isFirstDiagonalShorter(const Eigen::Matrix3Xd& quad) {
    return (quad.col(2) - quad.col(0)).norm() <= (quad.col(3) - quad.col(1)).norm();
  }

  int findEar(int begin) const {
    const int count = static_cast<int>(left_.size());
    for (int i = 0; i < count; ++i) {
      if (isEar((begin + i) % count)) return (begin + i) % count;
    }
    return begin;
  }

  /// Corners before, at and after place i of those left.
  Eigen::Vector3i triangleAt(int i) const {
    const int count = static_cast<int>(left_.size());
    return {left_[(i + count - 1) % count], left_[i], left_[(i + 1) % count]};
  }

  bool isEar(int i) const {
    const Eigen::Vector3i ear = triangleAt(i);
    const Eigen::Vector2d a = points_.col(ear[0]), b = points_.col(ear[1]), c = points_.col(ear[2]);
    if (cross(b - a, c - b) <= 0) return false;
    return std::ranges::none_of(left_, [&](int other) {
      const Eigen::Vector2d p = points_.col(other);
      const bool isCorner = p == a || p == b || p == c;
      return !isCorner && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
             cross(a - c, p - c) >= 0;
    });
  }

  Eigen::Matrix2Xd points_;
  std::vector<int> left_;
  int first_ = 0;
};

}  // namespace

std::optional<BadCorner> findBadCorner(const PolygonMesh& polygons) {
  const auto count = static_cast<int>(polygons.coordinates.size() / 3);
  const auto bad = std::ranges::find_if(polygons.corners,
                                        [&](int index) { return index < 0 || index >= count; });
  if (bad == polygons.corners.end()) return std::nullopt;
  int polygon = 0;
  for (auto left = bad - polygons.corners.begin(); left >= polygons.cornerCounts[polygon];) {
    left -= polygons.cornerCounts[polygon++];
  }
  return BadCorner{polygon, *bad};
}

std::vector<int> trianglesOfStrip(std::span<const int> strip) {
  std::vector<int> corners;
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const std::size_t flip = i % 2;
    const int a = strip[i - 2], b = strip[i - 1 + flip], c = strip[i - flip];
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
  }
  return corners;
}

std::vector<std::string> noticesOnFaces(std::size_t count) {
  if (count == 0) return {};
  return {fmt::format("passed over {} of fewer than three corners", countOf(count, "face"))};
}

TriangleMesh triangulate(const PolygonMesh& polygons) {
  TriangleMesh mesh;
  mesh.vertices =
      Eigen::Matrix3Xd::Map(polygons.coordinates.data(), 3, polygons.coordinates.size() / 3);
  const auto count = static_cast<Eigen::Index>(polygons.cornerCounts.size());
  mesh.triangles.resize(3, static_cast<Eigen::Index>(polygons.corners.size()) - 2 * count);
  Eigen::Index next = 0;
  std::size_t begin = 0;
  for (const int cornerCount : polygons.cornerCounts) {
    const auto corners = Eigen::VectorXi::Map(polygons.corners.data() + begin, cornerCount);
    begin += cornerCount;
    if (cornerCount == 3) {
      mesh.triangles.col(next++) = corners;
      continue;
    }
    for (const Eigen::Vector3i& triangle :
         EarClipping(mesh.vertices(Eigen::all, corners)).triangles()) {
      mesh.triangles.col(next++) = corners(triangle);
    }
  }
  return mesh;
}

}  // namespace morphgrid
