#include "surface/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

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

struct Search {
  const Eigen::Matrix3Xd& vertices;
  const Eigen::Matrix3Xi& triangles;
  Vector3d point;
  double squaredDistance;
};

/// Embree calls this for every triangle in reach; true tells it that the radius has shrunk.
bool visitTriangle(RTCPointQueryFunctionArguments* arguments) {
  auto& search = *static_cast<Search*>(arguments->userPtr);
  const Eigen::Vector3i corners = search.triangles.col(arguments->primID);
  const double squared =
      squaredDistanceToTriangle(search.point, search.vertices.col(corners[0]),
                                search.vertices.col(corners[1]), search.vertices.col(corners[2]));
  if (squared >= search.squaredDistance) {
    return false;
  }
  search.squaredDistance = squared;
  // The hierarchy is in single precision: keep a margin so that no closer triangle is passed over.
  arguments->query->radius = static_cast<float>(std::sqrt(squared) * (1 + 1e-5));
  return true;
}

}  // namespace

struct ClosestPointQuery::Scene {
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xi triangles;
  EmbreeMesh mesh;
};

ClosestPointQuery::ClosestPointQuery(const Eigen::Matrix3Xd& vertices,
                                     const Eigen::Matrix3Xi& triangles)
    : scene_(new Scene{vertices, triangles, {vertices.cast<float>(), triangles}}) {
  assert(triangles.cols() > 0);
}

ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;
ClosestPointQuery& ClosestPointQuery::operator=(ClosestPointQuery&&) noexcept = default;

double ClosestPointQuery::distance(const Vector3d& point) const {
  Search search{scene_->vertices, scene_->triangles, point,
                std::numeric_limits<double>::infinity()};
  scene_->mesh.query(point, std::numeric_limits<float>::infinity(), visitTriangle, &search);
  return std::sqrt(search.squaredDistance);
}

}  // namespace morphgrid
