#include "target/mesh_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/decimals.h"
#include "core/error.h"
#include "surface/box_text.h"
#include "surface/ray_hits.h"

namespace morphgrid {
namespace {

/// How far to either side normals look, in shares of the box.
constexpr double kNormalReach = 0.02;
constexpr double kSmallest = std::numeric_limits<double>::min();

std::string inWords(const Hole& hole) {
  return fmt::format("{} {} at u {:.4g} to {:.4g}, v {:.4g} to {:.4g}", hole.rays,
                     hole.rays == 1 ? "ray" : "rays", hole.uMin, hole.uMax, hole.vMin, hole.vMax);
}

/// x of a lattice, bilinear between its points; parameters in [0, 1].
double interpolateX(const RayHits& lattice, const Eigen::Vector2d& parameters) {
  const double u = parameters.x() * (lattice.countU - 1);
  const double v = parameters.y() * (lattice.countV - 1);
  const int i = std::min(static_cast<int>(u), lattice.countU - 2);
  const int j = std::min(static_cast<int>(v), lattice.countV - 2);
  const auto alongU = [&](int row) {
    return std::lerp(lattice.points(0, lattice.index(i, row)),
                     lattice.points(0, lattice.index(i + 1, row)), u - i);
  };
  return std::lerp(alongU(j), alongU(j + 1), v - j);
}

}  // namespace

RayHits MeshSampler::castAndFill(int countU, int countV) {
  RayHits hits = addSeconds(figures_.secondsRays,
                            [&] { return caster_.cast(rays_.box, countU, countV, cancellation_); });
  figures_.rays += static_cast<int>(hits.hit.size());
  figures_.missed += static_cast<int>(std::count(hits.hit.begin(), hits.hit.end(), 0));
  if (rays_.fillHoles > 0) {
    fillHoles(hits, rays_.fillHoles);
  }
  return hits;
}

RayHits MeshSampler::cast(int countU, int countV) {
  RayHits hits = castAndFill(countU, countV);
  requireHits(hits);
  requireGentleSteps(hits);
  return hits;
}

RayHits MeshSampler::cast(int countU, int countV, const RayHits& samples) {
  RayHits hits = castAndFill(countU, countV);
  for (int ray = 0; rays_.fillHoles > 0 && ray < static_cast<int>(hits.hit.size()); ++ray) {
    if (hits.hit[ray]) continue;
    const int row = ray / countU;
    const Eigen::Vector2d place(double(ray % countU) / (countU - 1), double(row) / (countV - 1));
    hits.points(0, ray) = interpolateX(samples, place);
    hits.hit[ray] = 1;
  }
  requireHits(hits);
  requireGentleSteps(hits);
  return hits;
}

Eigen::Matrix3Xd MeshSampler::castThrough(const Eigen::Matrix2Xd& parameters,
                                          const RayHits& lattice) {
  const SamplingBox& box = rays_.box;
  const Eigen::Matrix2Xd places =
      (Eigen::Vector2d(box.uLength, box.vLength).asDiagonal() * parameters).colwise() +
      Eigen::Vector2d(box.uStart, box.vStart);
  Eigen::Matrix3Xd points =
      addSeconds(figures_.secondsRays, [&] { return caster_.castThrough(places, cancellation_); });
  figures_.rays += static_cast<int>(points.cols());
  for (Eigen::Index n = 0; n < points.cols(); ++n) {
    if (!std::isnan(points(0, n))) continue;
    ++figures_.missed;
    if (rays_.fillHoles <= 0) {
      throw InputError(fmt::format(
          "a ray of the net misses {} at u {:.6g}, v {:.6g}, in a hole between the rays "
          "sampled before; let surface.fill_holes close it, or choose another box; {}",
          figures_.file, places(0, n), places(1, n), adviseOnBox(figures_)));
    }
    points(0, n) = interpolateX(lattice, parameters.col(n));
  }
  return points;
}

Eigen::Matrix3Xd MeshSampler::normals(const Eigen::Matrix2Xd& parameters, const RayHits& lattice) {
  const auto shifted = [&](double u, double v) {
    const Eigen::Vector2d shift(u, v);
    const Eigen::Matrix2Xd moved = parameters.colwise() + shift;
    return castThrough(moved.cwiseMax(0).cwiseMin(1), lattice);
  };
  const Eigen::Matrix3Xd alongU = shifted(kNormalReach, 0) - shifted(-kNormalReach, 0);
  const Eigen::Matrix3Xd alongV = shifted(0, kNormalReach) - shifted(0, -kNormalReach);
  Eigen::Matrix3Xd normals(3, parameters.cols());
  for (Eigen::Index n = 0; n < normals.cols(); ++n) {
    const Eigen::Vector3d u = alongU.col(n);
    normals.col(n) = u.cross(alongV.col(n)).normalized();
  }
  return normals;
}

void MeshSampler::requireHits(const RayHits& hits) const {
  const std::vector<Hole> holes = findHoles(hits);
  if (holes.empty()) {
    return;
  }
  int missed = 0;
  for (const Hole& hole : holes) {
    missed += hole.rays;
  }
  throw InputError(fmt::format(
      "{} of {} rays miss {} in {} {}, the largest of {}; let surface.fill_holes close holes up to "
      "a "
      "width, or choose another box; {}",
      missed, hits.hit.size(), figures_.file, holes.size(), holes.size() == 1 ? "hole" : "holes",
      inWords(holes.front()), adviseOnBox(figures_)));
}

void MeshSampler::requireGentleSteps(const RayHits& hits) {
  const Jump jump = findJump(hits, rays_.steepestSlope);
  figures_.largestJump = std::max(figures_.largestJump, jump.slope);
  if (jump.count == 0) {
    return;
  }
  throw InputError(fmt::format(
      "{} {} between neighbouring rays {} steeper than surface.steepest_slope = {:g}, the steepest "
      "({:.4g}) at u {:.4g}, v {:.4g}: an overhang seen from the side? Choose a box without it or "
      "raise that limit; {}",
      jump.count, jump.count == 1 ? "step" : "steps", jump.count == 1 ? "is" : "are",
      rays_.steepestSlope, jump.slope, jump.u, jump.v, adviseOnBox(figures_)));
}

std::string adviseOnBox(const MeshFigures& figures) {
  const Eigen::AlignedBox3d& extent = figures.extent;
  const Eigen::Vector3d sizes = extent.sizes();
  const int decimals = decimalsFor(1e-3 * std::max({sizes.y(), sizes.z(), kSmallest}));
  const auto text = [&](double value) { return inDecimals(value, decimals); };
  return fmt::format("the mesh spans u {} to {}, v {} to {}; {}", text(extent.min().y()),
                     text(extent.max().y()), text(extent.min().z()), text(extent.max().z()),
                     figures.suggestedBox
                         ? "a box without holes:\n" + boxAsToml(*figures.suggestedBox)
                         : "no box without holes was found");
}

}  // namespace morphgrid
