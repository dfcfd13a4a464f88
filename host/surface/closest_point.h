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

  /// The same of each of 3 x n points, on all cores: quickest where each lies near the one before.
  Eigen::VectorXd distances(const Eigen::Matrix3Xd& points) const;

 private:
  struct Scene;
  struct Search;

  void search(Search& search) const;

  std::unique_ptr<Scene> scene_;
};

}  // namespace morphgrid
