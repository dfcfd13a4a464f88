#pragma once
#include <Eigen/Core>
#include <memory>

namespace morphgrid {

/// Distances from points to a triangle mesh (Embree).
class ClosestPointQuery {
 public:
  /// vertices 3 x n, triangles 3 x m of vertex indices; m >= 1.
  ClosestPointQuery(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles);
  ~ClosestPointQuery();
  ClosestPointQuery(ClosestPointQuery&&) noexcept;
  ClosestPointQuery& operator=(ClosestPointQuery&&) noexcept;

  /// Distance from the point to the nearest point of the mesh, in the mesh's unit.
  double distance(const Eigen::Vector3d& point) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace morphgrid
