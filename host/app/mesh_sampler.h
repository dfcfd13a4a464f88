#pragma once
#include "app/mesh_target.h"
#include "report/run_record.h"

namespace morphgrid {

/// Samples a mesh target with rays, and keeps count.
class MeshSampler {
 public:
  /// Keeps a reference. Builds the hierarchy. Rays throw Cancelled where that is requested.
  explicit MeshSampler(const MeshTarget& target, Cancellation cancellation = {});

  /// A lattice of rays over the box; holes filled as far as the target allows. Throws InputError
  /// with advice when rays miss all the same or a step is too steep.
  RayHits cast(int countU, int countV);

  /// The hits of rays through the parameters, 2 x n in [0, 1]^2 of the box. Where holes may be
  /// filled, misses lie on `lattice`, an earlier cast; otherwise they are an InputError.
  Eigen::Matrix3Xd castThrough(const Eigen::Matrix2Xd& parameters, const RayHits& lattice);

  /// Unit normals p_u x p_v at the parameters, 3 x n: central differences over 4 % of the box,
  /// which smooth the facets; one-sided at its edges. `lattice` as above.
  Eigen::Matrix3Xd normals(const Eigen::Matrix2Xd& parameters, const RayHits& lattice);

  /// Of all rays so far.
  const MeshFigures& figures() const { return figures_; }

  /// What the mesh spans and a box without holes, for people to start from.
  std::string boxAdvice() const;

 private:
  void requireHits(const RayHits& hits) const;
  void requireGentleSteps(const RayHits& hits);

  const MeshTarget& target_;
  Cancellation cancellation_;
  MeshRayCaster caster_;
  MeshFigures figures_;
};

}  // namespace morphgrid
