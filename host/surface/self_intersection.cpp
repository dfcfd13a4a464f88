#include "surface/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>

#include "core/parallel_for.h"
#include "surface/embree_neighbourhood.h"

namespace morphgrid {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr int kTrianglesPerRange = 1024;

class TriangleSoup {
 public:
  TriangleSoup(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles)
      : vertices_(vertices), triangles_(triangles) {}

  bool cut(int a, int b) const {
    return !shareVertex(a, b) && boxOf(a).intersects(boxOf(b)) && meet(triangle(a), triangle(b));
  }

  Eigen::AlignedBox3d boxOf(int index) const {
    Eigen::AlignedBox3d box;
    for (const int vertex : triangles_.col(index)) {
      box.extend(vertices_.col(vertex));
    }
    return box;
  }

 private:
  bool shareVertex(int a, int b) const {
    for (const int vertex : triangles_.col(a)) {
      if ((triangles_.col(b).array() == vertex).any()) {
        return true;
      }
    }
    return false;
  }

  Kernel::Triangle_3 triangle(int index) const {
    const auto corner = [&](int n) {
      const Eigen::Vector3d p = vertices_.col(triangles_(n, index));
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    return {corner(0), corner(1), corner(2)};
  }

  static bool meet(const Kernel::Triangle_3& a, const Kernel::Triangle_3& b) {
    return !a.is_degenerate() && !b.is_degenerate() && CGAL::do_intersect(a, b);
  }

  const Eigen::Matrix3Xd& vertices_;
  const Eigen::Matrix3Xi& triangles_;
};

}  // namespace

std::vector<int> findSelfIntersections(const Eigen::Matrix3Xd& vertices,
                                       const Eigen::Matrix3Xi& triangles) {
  const TriangleSoup soup(vertices, triangles);
  const EmbreeNeighbourhood neighbourhood(vertices, triangles);
  std::vector<char> isCut(static_cast<std::size_t>(triangles.cols()));
  parallelFor(triangles.cols(), kTrianglesPerRange, [&](Eigen::Index n) {
    const int index = static_cast<int>(n);
    const Eigen::AlignedBox3d box = soup.boxOf(index);
    const double radius = box.diagonal().norm() / 2;
    bool cut = false;
    neighbourhood.visit(box.center(), radius, [&](int other) {
      cut = cut || soup.cut(index, other);
      return cut ? 0 : radius;
    });
    isCut[static_cast<std::size_t>(n)] = cut ? 1 : 0;
  });
  std::vector<int> found;
  for (std::size_t n = 0; n < isCut.size(); ++n) {
    if (isCut[n] != 0) found.push_back(static_cast<int>(n));
  }
  return found;
}

}  // namespace morphgrid
