#pragma once
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "core/cancellation.h"
#include "surface/point_lattice.h"
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// The part of the target that rays along +x sample: u is y, v is z, in the scene's unit of length.
struct SamplingBox {
  double uStart;
  double vStart;
  double uLength;  ///< > 0
  double vLength;  ///< > 0

  bool operator==(const SamplingBox&) const = default;
};

/// Where a lattice of rays along +x meets a mesh (Eqs. 7 - 10). Ray (i, j) runs through
/// y = uStart + i uStep, z = vStart + j vStep; the rays at both ends run along the box's edges.
struct RayHits {
  SamplingBox box;
  int countU;  ///< Rays along u, >= 2; uStep = uLength / (countU - 1).
  int countV;
  Eigen::Matrix3Xd points;  ///< 3 x countU countV, index j countU + i. Where missed, x is 0.
  std::vector<char> hit;    ///< 1 where the ray met the mesh.

  int index(int i, int j) const { return j * countU + i; }
  PointLattice lattice() const { return {countU, countV, points}; }
  double uStep() const { return box.uLength / (countU - 1); }
  double vStep() const { return box.vLength / (countV - 1); }
  /// The place of ray (i, j); the last one is exactly uStart + uLength.
  double u(int i) const { return box.uStart + box.uLength * (double(i) / (countU - 1)); }
  double v(int j) const { return box.vStart + box.vLength * (double(j) / (countV - 1)); }
};

/// Casts rays along +x at a mesh (Embree, packets, watertight). A ray beside the mesh's boundary by
/// no more than a millionth of the mesh's extent counts as on it. Points are computed in double
/// precision: y and z are the ray's own, x lies in the plane of the triangle hit.
class MeshRayCaster {
 public:
  explicit MeshRayCaster(const TriangleMesh& mesh);
  ~MeshRayCaster();
  MeshRayCaster(MeshRayCaster&&) noexcept;
  MeshRayCaster& operator=(MeshRayCaster&&) noexcept;

  /// The first hit of each ray. countU, countV >= 2.
  RayHits cast(const SamplingBox& box, int countU, int countV,
               const Cancellation& cancellation = {}) const;

  /// The first hit of rays through arbitrary places, 2 x n of (y, z). Where missed, x is NaN.
  Eigen::Matrix3Xd castThrough(const Eigen::Matrix2Xd& places,
                               const Cancellation& cancellation = {}) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace morphgrid
