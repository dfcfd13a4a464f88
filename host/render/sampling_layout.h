#pragma once
#include <algorithm>

#include "render/camera.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// The isolines that a picture of many rays shows: every stride-th and the last.
struct DrawnIsolines {
  static constexpr int kMostCells = 40;  ///< Between them: more would hide the mesh.

  int rays;    ///< Isolines of the lattice, >= 2.
  int stride;  ///< Rays from one to the next; the last may follow sooner.
  int count;

  explicit DrawnIsolines(int rayCount)
      : rays(rayCount),
        stride(1 + (rayCount - 2) / kMostCells),
        count(2 + (rayCount - 2) / stride) {}

  /// 0 <= n < count.
  int at(int n) const { return std::min(n * stride, rays - 1); }
};

/// How the picture of a mesh's rays is laid out.
struct SamplingLayout {
  /// The rays' box in y and z and what they met in x, in the scene's unit of length. Where nothing
  /// was met, x is the mesh's own.
  Eigen::AlignedBox3d sampled;
  DrawnIsolines columns;  ///< i of the drawn isolines along v.
  DrawnIsolines rows;     ///< j of the drawn isolines along u.
  double rayStep;         ///< The shorter distance of neighbouring rays, in the scene's unit.
  double cell;            ///< The same of drawn isolines.
};

SamplingLayout layOutSampling(const TriangleMesh& mesh, const RayHits& hits);

/// The camera that sees the sampled part of a mesh as the rays do: along +x, y up, z to the right.
/// The mesh around it may be cut off. aspect = width / height of the picture, > 0.
Camera frameRays(const TriangleMesh& mesh, const RayHits& hits, double aspect);

/// The hits where drawn isolines cross, 3 x n.
Eigen::Matrix3Xd crossingHits(const SamplingLayout& layout, const RayHits& hits);

/// A mark for missed rays of each cell between drawn isolines, 3 x n: the middle of those rays, at
/// the middle depth of what was sampled. Every missed ray has its mark, alone or shared.
Eigen::Matrix3Xd missedMarks(const SamplingLayout& layout, const RayHits& hits);

}  // namespace morphgrid
