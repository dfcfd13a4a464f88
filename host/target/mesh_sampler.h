#pragma once
#include <chrono>

#include "core/cancellation.h"
#include "target/mesh_figures.h"

namespace morphgrid {

/// Where rays run, and what is not an error.
struct RaySettings {
  SamplingBox box;       ///< In the scene's unit of length.
  double fillHoles;      ///< Holes up to this width are filled; the scene's unit of length.
  double steepestSlope;  ///< Largest abs(dx) / distance of neighbouring rays that is accepted.
};

/// Samples a mesh with rays, and keeps count.
class MeshSampler {
 public:
  /// Keeps a reference to the caster. figures: of the mesh and its rays so far. Rays throw
  /// Cancelled where that is requested.
  MeshSampler(const MeshRayCaster& caster, const RaySettings& rays, MeshFigures figures,
              Cancellation cancellation = {})
      : caster_(caster),
        rays_(rays),
        figures_(std::move(figures)),
        cancellation_(std::move(cancellation)) {}

  /// Casts a lattice of countU x countV rays, >= 2 each, over the box (Eqs. 7 - 10); fills holes as
  /// far as the settings allow. Throws InputError
  /// with advice when rays miss all the same or a step is too steep.
  RayHits cast(int countU, int countV);
  /// The same where holes that may be filled can be too wide for a coarse lattice's own rim: then
  /// rays lie on `samples`, an earlier cast.
  RayHits cast(int countU, int countV, const RayHits& samples);

  /// The hits, 3 x n, of rays through the parameters, 2 x n in [0, 1]^2 of the box. Where holes may
  /// be filled, misses lie on `lattice`, an earlier cast; otherwise they are an InputError.
  Eigen::Matrix3Xd castThrough(const Eigen::Matrix2Xd& parameters, const RayHits& lattice);

  /// Unit normals p_u x p_v at the parameters, 3 x n: central differences over 4 % of the box,
  /// which smooth the facets; one-sided at its edges. `lattice` as above.
  Eigen::Matrix3Xd normals(const Eigen::Matrix2Xd& parameters, const RayHits& lattice);

  /// Figures of all rays so far.
  const MeshFigures& figures() const { return figures_; }

 private:
  RayHits castAndFill(int countU, int countV);
  void requireHits(const RayHits& hits) const;
  void requireGentleSteps(const RayHits& hits);

  const MeshRayCaster& caster_;
  RaySettings rays_;
  MeshFigures figures_;
  Cancellation cancellation_;
};

/// What the mesh spans and a box without holes, for people to start from.
std::string adviseOnBox(const MeshFigures& figures);

/// The result of some work; what it took is added to `seconds`.
template <typename Work>
auto addSeconds(double& seconds, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace morphgrid
