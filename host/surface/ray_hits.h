#pragma once
#include <optional>
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

/// |dx| / step from ray (i, j) to the next along u or v; 0 where one of the two misses.
double slopeAlongU(const RayHits& hits, int i, int j);
double slopeAlongV(const RayHits& hits, int i, int j);

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

/// The box of largest area in which no ray of the lattice misses and no step is steeper than
/// slopeLimit, its edges on rays; nothing when there is none of at least 4 x 4 rays.
std::optional<SamplingBox> largestBoxWithoutHoles(const RayHits& hits, double slopeLimit);

/// Searches an extent for such a box that also the rays of every later stage find without a hole
/// or a steeper step: countU x countV samples, the maps of nets and grids of any usual size. Holes
/// up to fillHoles are closed first, see fillHoles(). The box keeps a little away from what bounds
/// it and is written in few digits, see boxAsToml(). countU, countV >= 4; nothing when none is
/// found.
std::optional<SamplingBox> suggestBox(const MeshRayCaster& caster,
                                      const Eigen::AlignedBox3d& extent, int countU, int countV,
                                      double slopeLimit, double fillHoles = 0);

}  // namespace morphgrid
