#include "surface/segment_clearance.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <limits>

#include "core/parallel_for.h"
#include "surface/embree_neighbourhood.h"

namespace morphgrid {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

constexpr int kSegmentsPerRange = 1024;

/// Embree has no segments without thickness: triangles with two corners at one place stand for
/// them.
Eigen::Matrix3Xi asTriangles(const Matrix2Xi& segments) {
  Eigen::Matrix3Xi triangles(3, segments.cols());
  triangles.topRows<2>() = segments;
  triangles.row(2) = segments.row(1);
  return triangles;
}

bool shareEnd(const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

}  // namespace

Eigen::VectorXd segmentClearances(const Eigen::Matrix3Xd& points, const Matrix2Xi& segments,
                                  double reach) {
  const EmbreeNeighbourhood neighbourhood(points, asTriangles(segments));
  const auto segment = [&](Eigen::Index index) {
    const Eigen::Vector3d a = points.col(segments(0, index));
    const Eigen::Vector3d b = points.col(segments(1, index));
    return Kernel::Segment_3({a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()});
  };
  Eigen::VectorXd clearances(segments.cols());
  parallelFor(segments.cols(), kSegmentsPerRange, [&](Eigen::Index index) {
    const Eigen::Vector3d from = points.col(segments(0, index));
    const Eigen::Vector3d to = points.col(segments(1, index));
    const double halfLength = (to - from).norm() / 2;
    double closest = reach;
    neighbourhood.visit((from + to) / 2, halfLength + reach, [&](int other) {
      if (!shareEnd(segments.col(index), segments.col(other))) {
        closest =
            std::min(closest, std::sqrt(CGAL::squared_distance(segment(index), segment(other))));
      }
      return halfLength + closest;
    });
    clearances[index] = closest < reach ? closest : std::numeric_limits<double>::infinity();
  });
  return clearances;
}

}  // namespace morphgrid
