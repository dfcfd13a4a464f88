#include <algorithm>
#include <cmath>

#include "propose/sight.h"
#include "surface/main_extent.h"
#include "surface/ray_hits.h"

namespace morphgrid {
namespace {

constexpr int kLookRays = 120;       // Along either side of what is looked at.
constexpr double kLookSlope = 20;    // Steeper than 87 degrees, rays see too little to go by.
constexpr double kSmallHole = 0.06;  // Of the extent: such holes are filled.
constexpr double kAlmost = 0.02;     // Shares that differ by less are alike.

/// Positive areas of triangles that turn their outside to rays along +x, less those of others.
double facingArea(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Eigen::Matrix3d corners = mesh.vertices(Eigen::all, triangle);
    const Eigen::Vector3d first = corners.col(1) - corners.col(0);
    const Eigen::Vector3d second = corners.col(2) - corners.col(0);
    sum -= first.cross(second).x() / 2;
  }
  return sum;
}

SightRating rate(const TriangleMesh& mesh, const Sight& sight, double meshArea,
                 const Cancellation& cancellation) {
  SightRating rating{.sight = sight};
  const TriangleMesh turned = transformed(Eigen::Affine3d(sight.rotation()), mesh);
  const Eigen::AlignedBox3d extent = mainExtent(turned);
  const Eigen::Vector3d sizes = extent.sizes();
  if (!(sizes.y() > 0 && sizes.z() > 0)) return rating;
  const MeshRayCaster caster(turned);
  RayHits hits = caster.cast({extent.min().y(), extent.min().z(), sizes.y(), sizes.z()}, kLookRays,
                             kLookRays, cancellation);
  fillHoles(hits, kSmallHole * std::max(sizes.y(), sizes.z()));
  rating.box = largestBoxWithoutHoles(hits, kLookSlope);
  rating.facing = facingArea(turned) / meshArea;
  if (rating.box) {
    RayHits inBox = caster.cast(*rating.box, kLookRays, kLookRays, cancellation);
    fillHoles(inBox, kSmallHole * std::max(sizes.y(), sizes.z()));
    rating.share = areaBetween(inBox) / meshArea;
  }
  return rating;
}

/// Of those that see about the most, the first that sees the outside best.
std::vector<SightRating>::iterator bestOf(std::vector<SightRating>& ratings) {
  const auto most = std::ranges::max_element(ratings, {}, &SightRating::share);
  const double enough = most->share * (1 - kAlmost);
  return std::ranges::max_element(ratings, {}, [&](const SightRating& rating) {
    return rating.share >= enough ? std::lround(100 * rating.facing) : -1000L;
  });
}

}  // namespace

double areaBetween(const RayHits& hits) {
  double area = 0;
  const PointLattice points = hits.lattice();
  for (int j = 0; j + 1 < hits.countV; ++j) {
    for (int i = 0; i + 1 < hits.countU; ++i) {
      if (!hits.hit[hits.index(i, j)] || !hits.hit[hits.index(i + 1, j)] ||
          !hits.hit[hits.index(i, j + 1)] || !hits.hit[hits.index(i + 1, j + 1)]) {
        continue;
      }
      const Eigen::Vector3d across = points.at(i + 1, j + 1) - points.at(i, j);
      const Eigen::Vector3d other = points.at(i, j + 1) - points.at(i + 1, j);
      area += across.cross(other).norm() / 2;
    }
  }
  return area;
}

std::vector<SightRating> rateSights(const TriangleMesh& mesh, const std::vector<Sight>& sights,
                                    const Cancellation& cancellation) {
  const double area = surfaceArea(mesh);
  std::vector<SightRating> ratings;
  for (const Sight& sight : sights) {
    cancellation.check();
    ratings.push_back(rate(mesh, sight, area, cancellation));
  }
  std::vector<SightRating> sorted;
  while (!ratings.empty()) {
    const auto best = bestOf(ratings);
    sorted.push_back(*best);
    ratings.erase(best);
  }
  return sorted;
}

}  // namespace morphgrid
