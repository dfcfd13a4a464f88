#include <cassert>

#include "surface/ray_hits.h"

namespace morphgrid {
namespace {

constexpr int kLeastCells = 3;     ///< Along a side of a box: 4 rays, as splines need.
constexpr int kLatticeRays = 200;  ///< Along either side of the mesh's extent.
constexpr int kMostAttempts = 20;

/// A rectangle of cells between the rays of a lattice.
struct CellBox {
  int firstU = 0, firstV = 0;
  int cellsU = 0, cellsV = 0;

  long area() const { return long(cellsU) * cellsV; }
};

/// Whether the four rays around a cell hit and none of its four sides is too steep.
bool isWhole(const RayHits& hits, int i, int j, double slopeLimit) {
  return hits.hit[hits.index(i, j)] && hits.hit[hits.index(i + 1, j)] &&
         hits.hit[hits.index(i, j + 1)] && hits.hit[hits.index(i + 1, j + 1)] &&
         slopeAlongU(hits, i, j) <= slopeLimit && slopeAlongU(hits, i, j + 1) <= slopeLimit &&
         slopeAlongV(hits, i, j) <= slopeLimit && slopeAlongV(hits, i + 1, j) <= slopeLimit;
}

/// The largest box that ends below row `endV`, heights[i] whole cells standing there in column i:
/// the largest rectangle under a histogram, by a stack of rising heights.
CellBox largestBelow(const std::vector<int>& heights, int endV) {
  struct Step {
    int start, height;
  };
  std::vector<Step> steps;
  CellBox best;
  for (int i = 0; i <= int(heights.size()); ++i) {
    const int height = i < int(heights.size()) ? heights[i] : 0;
    int start = i;
    while (!steps.empty() && steps.back().height >= height) {
      start = steps.back().start;
      const int tall = steps.back().height;
      const CellBox box{start, endV - tall, i - start, tall};
      if (box.cellsU >= kLeastCells && box.cellsV >= kLeastCells && box.area() > best.area()) {
        best = box;
      }
      steps.pop_back();
    }
    steps.push_back({start, height});
  }
  return best;
}

/// One step of the lattice off every side.
SamplingBox inset(const SamplingBox& box, double uStep, double vStep) {
  return {box.uStart + uStep, box.vStart + vStep, box.uLength - 2 * uStep, box.vLength - 2 * vStep};
}

bool isWhole(const RayHits& hits, double slopeLimit) {
  return findHoles(hits).empty() && findJump(hits, slopeLimit).count == 0;
}

}  // namespace

std::optional<SamplingBox> largestBoxWithoutHoles(const RayHits& hits, double slopeLimit) {
  CellBox best;
  std::vector<int> heights(hits.countU - 1, 0);
  for (int j = 0; j + 1 < hits.countV; ++j) {
    for (int i = 0; i + 1 < hits.countU; ++i) {
      heights[i] = isWhole(hits, i, j, slopeLimit) ? heights[i] + 1 : 0;
    }
    const CellBox box = largestBelow(heights, j + 1);
    if (box.area() > best.area()) {
      best = box;
    }
  }
  if (best.area() == 0) {
    return std::nullopt;
  }
  return SamplingBox{hits.u(best.firstU), hits.v(best.firstV), best.cellsU * hits.uStep(),
                     best.cellsV * hits.vStep()};
}

std::optional<SamplingBox> suggestBox(const MeshRayCaster& caster,
                                      const Eigen::AlignedBox3d& extent, int countU, int countV,
                                      double slopeLimit) {
  assert(countU > kLeastCells && countV > kLeastCells);
  const Eigen::Vector3d sizes = extent.sizes();
  if (!(sizes.y() > 0 && sizes.z() > 0)) {
    return std::nullopt;
  }
  const SamplingBox all{extent.min().y(), extent.min().z(), sizes.y(), sizes.z()};
  RayHits hits = caster.cast(all, kLatticeRays, kLatticeRays);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const auto largest = largestBoxWithoutHoles(hits, slopeLimit);
    if (!largest) {
      return std::nullopt;
    }
    hits = caster.cast(inset(*largest, hits.uStep(), hits.vStep()), countU, countV);
    if (isWhole(hits, slopeLimit)) {
      return hits.box;
    }
  }
  return std::nullopt;
}

}  // namespace morphgrid
