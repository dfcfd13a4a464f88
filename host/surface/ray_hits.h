#pragma once
#include <optional>
#include <string>
#include <vector>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// Rays that miss and touch each other, along u, v or diagonally.
struct Hole {
  int rays;           ///< How many.
  double uMin, uMax;  ///< Where, in the scene's unit of length.
  double vMin, vMax;
};

/// All holes, the largest first.
std::vector<Hole> findHoles(const RayHits& hits);

/// The steepest step between neighbouring rays that hit: |dx| over the distance of the rays.
struct Jump {
  double slope = 0;  ///< 0 where no two neighbours hit.
  double u = 0;      ///< Midway between the two, in the scene's unit of length.
  double v = 0;
  int count = 0;  ///< Pairs of neighbours steeper than the limit.
};
Jump findJump(const RayHits& hits, double limit);

/// Closes the holes no larger than `widest` in either direction, rays beside them counted in
/// (scene's unit of length), by interpolation from the rim: the discrete Laplace equation for x.
/// Holes at the box's edge stay. Returns the number of rays filled.
int fillHoles(RayHits& hits, double widest);

/// The largest box in which no ray of the lattice misses and no step is steeper than slopeLimit;
/// nothing when there is none of at least 4 x 4 rays.
std::optional<SamplingBox> largestBoxWithoutHoles(const RayHits& hits, double slopeLimit);

/// Searches the mesh's extent for such a box, verified with countU x countV rays.
std::optional<SamplingBox> suggestBox(const MeshRayCaster& caster,
                                      const Eigen::AlignedBox3d& extent, int countU, int countV,
                                      double slopeLimit);

}  // namespace morphgrid
