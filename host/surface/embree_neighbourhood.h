#pragma once
#include <Eigen/Core>
#include <functional>

#include "surface/embree_mesh.h"

namespace morphgrid {

/// Which triangles of a mesh are near a point. Private to this folder.
class EmbreeNeighbourhood {
 public:
  /// As EmbreeMesh; in double precision.
  EmbreeNeighbourhood(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles);

  /// Gets a triangle's column; returns the radius from there on, at most the one before.
  using Visitor = std::function<double(int triangle)>;

  /// Visits, in any order, every triangle that comes within the radius of the point, and others
  /// whose bounds do.
  void visit(const Eigen::Vector3d& point, double radius, const Visitor& visitor) const;

 private:
  EmbreeMesh mesh_;
  double rounding_;  ///< How far single precision may have moved anything.
};

}  // namespace morphgrid
