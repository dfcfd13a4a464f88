#include <algorithm>
#include <cassert>
#include <cmath>

#include "surface/box_text.h"
#include "surface/ray_hits.h"

namespace morphgrid {
namespace {

constexpr int kLeastCells = 3;     ///< Along a side of a box: 4 rays, as splines need.
constexpr int kLatticeRays = 200;  ///< Along either side of the mesh's extent.
constexpr int kMostAttempts = 40;
constexpr int kMapRays = 161;  // Along either side, of the lattice that nets are mapped from.
constexpr int kFewestNodes = 8, kMostNodes = 48;  // Of grids, along the longer side.

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

/// A search in a lattice over the mesh's extent, in which rays are struck out where others, closer
/// or elsewhere, have found a hole or a step.
class BoxSearch {
 public:
  BoxSearch(const MeshRayCaster& caster, RayHits lattice, double slopeLimit, double fillHoles)
      : caster_(caster),
        lattice_(std::move(lattice)),
        slopeLimit_(slopeLimit),
        fillHoles_(fillHoles) {}

  /// The largest box that is left, a step of the lattice off what bounds it.
  std::optional<SamplingBox> largest() const {
    const auto box = largestBoxWithoutHoles(lattice_, slopeLimit_);
    if (!box) return std::nullopt;
    return roundedBox(inset(*box, lattice_.uStep(), lattice_.vStep()));
  }

  /// Whether rays of these counts find nothing in the box; strikes out what they find.
  bool verify(const SamplingBox& box, int countU, int countV) {
    RayHits hits = caster_.cast(box, countU, countV);
    if (fillHoles_ > 0) fillHoles(hits, fillHoles_);
    bool isWhole = true;
    const auto strikeIf = [&](bool isBad, int firstI, int firstJ, int lastI, int lastJ) {
      if (!isBad) return;
      strikeOut(hits.u(firstI), hits.v(firstJ));
      strikeOut(hits.u(lastI), hits.v(lastJ));
      isWhole = false;
    };
    for (int j = 0; j < countV; ++j) {
      for (int i = 0; i < countU; ++i) {
        strikeIf(!hits.hit[hits.index(i, j)], i, j, i, j);
        strikeIf(i + 1 < countU && slopeAlongU(hits, i, j) > slopeLimit_, i, j, i + 1, j);
        strikeIf(j + 1 < countV && slopeAlongV(hits, i, j) > slopeLimit_, i, j, i, j + 1);
      }
    }
    return isWhole;
  }

 private:
  /// The ray of the lattice that is nearest.
  void strikeOut(double u, double v) {
    const auto nearest = [](double place, double start, double step, int count) {
      return std::clamp(static_cast<int>(std::lround((place - start) / step)), 0, count - 1);
    };
    const int i = nearest(u, lattice_.box.uStart, lattice_.uStep(), lattice_.countU);
    const int j = nearest(v, lattice_.box.vStart, lattice_.vStep(), lattice_.countV);
    lattice_.hit[lattice_.index(i, j)] = 0;
  }

  const MeshRayCaster& caster_;
  RayHits lattice_;
  double slopeLimit_;
  double fillHoles_;
};

/// Whether the rays of every later stage find nothing: the samples', the maps' of nets, and, where
/// no holes are filled, those of grids of any usual size.
bool verifyAll(BoxSearch& search, const SamplingBox& box, int countU, int countV, bool fillsHoles) {
  bool isWhole = search.verify(box, countU, countV) && search.verify(box, kMapRays, kMapRays);
  const double aspect = box.vLength / box.uLength;
  for (int nodes = kFewestNodes; isWhole && !fillsHoles && nodes <= kMostNodes; ++nodes) {
    const int nodesU = std::max(1, static_cast<int>(std::ceil(nodes * std::min(1.0, 1 / aspect))));
    const int nodesV = std::max(1, static_cast<int>(std::ceil(nodes * std::min(1.0, aspect))));
    isWhole = search.verify(box, nodesU + 1, nodesV + 1);
  }
  return isWhole;
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
                                      double slopeLimit, double fillHoles) {
  assert(countU > kLeastCells && countV > kLeastCells);
  const Eigen::Vector3d sizes = extent.sizes();
  if (!(sizes.y() > 0 && sizes.z() > 0)) {
    return std::nullopt;
  }
  const SamplingBox all{extent.min().y(), extent.min().z(), sizes.y(), sizes.z()};
  RayHits lattice = caster.cast(all, kLatticeRays, kLatticeRays);
  if (fillHoles > 0) morphgrid::fillHoles(lattice, fillHoles);
  BoxSearch search(caster, std::move(lattice), slopeLimit, fillHoles);
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    const auto box = search.largest();
    if (!box || verifyAll(search, *box, countU, countV, fillHoles > 0)) {
      return box;
    }
  }
  return std::nullopt;
}

}  // namespace morphgrid
