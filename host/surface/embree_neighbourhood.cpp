#include "surface/embree_neighbourhood.h"

#include <limits>

namespace morphgrid {
namespace {

struct Visit {
  const EmbreeNeighbourhood::Visitor& visitor;
  double rounding;

  /// Never too small for what was asked.
  float queryRadius(double radius) const {
    return static_cast<float>((radius + rounding) * (1 + 1e-6));
  }
};

/// Embree calls this for every triangle in reach; true tells it that the radius has shrunk.
bool visitTriangle(RTCPointQueryFunctionArguments* arguments) {
  const auto& visit = *static_cast<const Visit*>(arguments->userPtr);
  const double radius = visit.visitor(static_cast<int>(arguments->primID));
  const float queryRadius = visit.queryRadius(radius);
  const bool shrunk = queryRadius < arguments->query->radius;
  arguments->query->radius = queryRadius;
  return shrunk;
}

}  // namespace

EmbreeNeighbourhood::EmbreeNeighbourhood(const Eigen::Matrix3Xd& vertices,
                                         const Eigen::Matrix3Xi& triangles)
    : mesh_(vertices.cast<float>(), triangles, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_LOW),
      rounding_(4 * std::numeric_limits<float>::epsilon() * vertices.cwiseAbs().maxCoeff()) {}

void EmbreeNeighbourhood::visit(const Eigen::Vector3d& point, double radius,
                                const Visitor& visitor) const {
  Visit visit{visitor, rounding_};
  mesh_.query(point, visit.queryRadius(radius), visitTriangle, &visit);
}

}  // namespace morphgrid
