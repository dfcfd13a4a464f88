#pragma once
#include "app/mesh_target.h"
#include "report/run_record.h"

namespace morphgrid {

/// Samples a mesh target with rays, and keeps count.
class MeshSampler {
 public:
  /// Keeps a reference. Builds the hierarchy.
  explicit MeshSampler(const MeshTarget& target);

  /// A lattice of rays over the box; holes filled as far as the target allows. Throws InputError
  /// with advice when rays miss all the same or a step is too steep.
  RayHits cast(int countU, int countV);

  /// Of all rays so far.
  const MeshFigures& figures() const { return figures_; }

  /// What the mesh spans and a box without holes, for people to start from.
  std::string boxAdvice() const;

 private:
  void requireHits(const RayHits& hits) const;
  void requireGentleSteps(const RayHits& hits);

  const MeshTarget& target_;
  MeshRayCaster caster_;
  MeshFigures figures_;
};

}  // namespace morphgrid
