#include "surface/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/parallel_for.h"
#include "surface/embree_mesh.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

/// The point of segment a-b that is closest to p.
Vector3d closestOnSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d edge = b - a;
  const double length2 = edge.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return a + t * edge;
}

double squaredDistanceToTriangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                                 const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const bool inside = normal.squaredNorm() > 0 && normal.dot((b - a).cross(p - a)) >= 0 &&
                      normal.dot((c - b).cross(p - b)) >= 0 &&
                      normal.dot((a - c).cross(p - c)) >= 0;
  if (inside) {
    const double height = normal.normalized().dot(p - a);
    return height * height;
  }
  return std::min({(p - closestOnSegment(p, a, b)).squaredNorm(),
                   (p - closestOnSegment(p, b, c)).squaredNorm(),
                   (p - closestOnSegment(p, c, a)).squaredNorm()});
}

constexpr int kPointsPerRange = 512;

}  // namespace

struct ClosestPointQuery::Scene {
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xi triangles;
  EmbreeMesh mesh;
  double rounding;  ///< How far single precision moves what it holds.

  double squaredDistance(const Vector3d& point, unsigned triangle) const {
    const auto corner = [&](int n) { return vertices.col(triangles(n, triangle)); };
    return squaredDistanceToTriangle(point, corner(0), corner(1), corner(2));
  }

  /// Of a query that passes over no triangle within that distance.
  float radiusFor(double squaredDistance) const {
    return static_cast<float>((std::sqrt(squaredDistance) + rounding) * (1 + 1e-5));
  }
};

struct ClosestPointQuery::Search {
  const Scene& scene;
  Vector3d point;
  double squaredDistance = std::numeric_limits<double>::infinity();
  unsigned triangle = RTC_INVALID_GEOMETRY_ID;  ///< The closest so far.

  void begin(const Vector3d& from) {
    point = from;
    squaredDistance = triangle == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<double>::infinity()
                                                          : scene.squaredDistance(point, triangle);
  }

  /// Embree calls this for every triangle in reach; true tells it that the radius has shrunk.
  static bool visit(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    const double squared = search.scene.squaredDistance(search.point, arguments->primID);
    if (squared >= search.squaredDistance) return false;
    search.squaredDistance = squared;
    search.triangle = arguments->primID;
    arguments->query->radius = search.scene.radiusFor(squared);
    return true;
  }
};

ClosestPointQuery::ClosestPointQuery(const Eigen::Matrix3Xd& vertices,
                                     const Eigen::Matrix3Xi& triangles)
    : scene_(
          new Scene{vertices,
                    triangles,
                    {vertices.cast<float>(), triangles, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_LOW},
                    4 * std::numeric_limits<float>::epsilon() * vertices.cwiseAbs().maxCoeff()}) {
  assert(triangles.cols() > 0);
}

ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;
ClosestPointQuery& ClosestPointQuery::operator=(ClosestPointQuery&&) noexcept = default;

void ClosestPointQuery::search(Search& search) const {
  scene_->mesh.query(search.point, scene_->radiusFor(search.squaredDistance), Search::visit,
                     &search);
}

double ClosestPointQuery::distance(const Vector3d& point) const {
  Search closest{*scene_, point};
  search(closest);
  return std::sqrt(closest.squaredDistance);
}

Eigen::VectorXd ClosestPointQuery::distances(const Eigen::Matrix3Xd& points) const {
  Eigen::VectorXd distances(points.cols());
  parallelRanges(points.cols(), kPointsPerRange, [&](Eigen::Index first, Eigen::Index last) {
    Search closest{*scene_, {}};
    for (Eigen::Index n = first; n < last; ++n) {
      closest.begin(points.col(n));  // No farther than the triangle that the last point was near.
      search(closest);
      distances[n] = std::sqrt(closest.squaredDistance);
    }
  });
  return distances;
}

}  // namespace morphgrid
