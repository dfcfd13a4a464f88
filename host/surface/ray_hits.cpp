#include "surface/ray_hits.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

double slopeBetween(const RayHits& hits, int a, int b, double distance) {
  return hits.hit[a] && hits.hit[b] ? std::abs(hits.points(0, a) - hits.points(0, b)) / distance
                                    : 0;
}

/// The rays of a hole and their range of indices.
struct MissedRays {
  std::vector<int> rays;
  Eigen::AlignedBox2i range;
};

/// Collects the missed rays that hang together with ray (i, j), which has missed.
MissedRays collectMissed(const RayHits& hits, int i, int j, std::vector<char>& seen) {
  MissedRays hole;
  const auto visit = [&](int column, int row) {
    const int ray = hits.index(column, row);
    if (!hits.hit[ray] && !seen[ray]) {
      seen[ray] = 1;
      hole.rays.push_back(ray);
      hole.range.extend(Eigen::Vector2i(column, row));
    }
  };
  visit(i, j);
  for (std::size_t next = 0; next < hole.rays.size(); ++next) {
    const int column = hole.rays[next] % hits.countU;
    const int row = hole.rays[next] / hits.countU;
    for (int besideV = std::max(row - 1, 0); besideV <= std::min(row + 1, hits.countV - 1);
         ++besideV) {
      for (int besideU = std::max(column - 1, 0); besideU <= std::min(column + 1, hits.countU - 1);
           ++besideU) {
        visit(besideU, besideV);
      }
    }
  }
  return hole;
}

std::vector<MissedRays> collectHoles(const RayHits& hits) {
  std::vector<MissedRays> holes;
  std::vector<char> seen(hits.hit.size(), 0);
  for (int j = 0; j < hits.countV; ++j) {
    for (int i = 0; i < hits.countU; ++i) {
      const int ray = hits.index(i, j);
      if (!hits.hit[ray] && !seen[ray]) {
        holes.push_back(collectMissed(hits, i, j, seen));
      }
    }
  }
  return holes;
}

bool canBeFilled(const MissedRays& hole, const RayHits& hits, double widest) {
  const Eigen::Vector2i first = hole.range.min();
  const Eigen::Vector2i last = hole.range.max();
  const bool inside =
      first.x() > 0 && first.y() > 0 && last.x() + 1 < hits.countU && last.y() + 1 < hits.countV;
  const double limit = widest * (1 + 1e-9);  // A width of just so many steps shall count.
  return inside && (last.x() - first.x() + 2) * hits.uStep() <= limit &&
         (last.y() - first.y() + 2) * hits.vStep() <= limit;
}

/// Solves the discrete Laplace equation for x at the given rays, none of them at the box's edge.
void interpolate(RayHits& hits, const std::vector<int>& rays) {
  std::vector<int> unknownOf(hits.hit.size(), -1);
  for (std::size_t n = 0; n < rays.size(); ++n) {
    unknownOf[rays[n]] = int(n);
  }
  const double ratio = hits.uStep() / hits.vStep();
  const double weightU = 1 / (1 + ratio * ratio);
  const double weightV = 1 - weightU;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rim = Eigen::VectorXd::Zero(Eigen::Index(rays.size()));
  for (int n = 0; n < int(rays.size()); ++n) {
    entries.emplace_back(n, n, 2);
    for (const auto& [beside, weight] :
         {std::pair{rays[n] - 1, weightU}, std::pair{rays[n] + 1, weightU},
          std::pair{rays[n] - hits.countU, weightV}, std::pair{rays[n] + hits.countU, weightV}}) {
      if (unknownOf[beside] >= 0) {
        entries.emplace_back(n, unknownOf[beside], -weight);
      } else {
        rim[n] += weight * hits.points(0, beside);
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(rim.size(), rim.size());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd x =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(rim);
  for (std::size_t n = 0; n < rays.size(); ++n) {
    hits.points(0, rays[n]) = x[Eigen::Index(n)];
    hits.hit[rays[n]] = 1;
  }
}

}  // namespace

double slopeAlongU(const RayHits& hits, int i, int j) {
  return slopeBetween(hits, hits.index(i, j), hits.index(i + 1, j), hits.uStep());
}

double slopeAlongV(const RayHits& hits, int i, int j) {
  return slopeBetween(hits, hits.index(i, j), hits.index(i, j + 1), hits.vStep());
}

std::vector<Hole> findHoles(const RayHits& hits) {
  std::vector<Hole> holes;
  for (const auto& [rays, range] : collectHoles(hits)) {
    holes.push_back({int(rays.size()), hits.u(range.min().x()), hits.u(range.max().x()),
                     hits.v(range.min().y()), hits.v(range.max().y())});
  }
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.rays > b.rays; });
  return holes;
}

Jump findJump(const RayHits& hits, double limit) {
  Jump jump;
  const auto compare = [&](double slope, double u, double v) {
    jump.count += slope > limit;
    if (slope > jump.slope) {
      jump.slope = slope;
      jump.u = u;
      jump.v = v;
    }
  };
  for (int j = 0; j < hits.countV; ++j) {
    for (int i = 0; i < hits.countU; ++i) {
      if (i + 1 < hits.countU) {
        compare(slopeAlongU(hits, i, j), hits.u(i) + hits.uStep() / 2, hits.v(j));
      }
      if (j + 1 < hits.countV) {
        compare(slopeAlongV(hits, i, j), hits.u(i), hits.v(j) + hits.vStep() / 2);
      }
    }
  }
  return jump;
}

int fillHoles(RayHits& hits, double widest) {
  std::vector<int> filled;
  for (const MissedRays& hole : collectHoles(hits)) {
    if (canBeFilled(hole, hits, widest)) {
      filled.insert(filled.end(), hole.rays.begin(), hole.rays.end());
    }
  }
  if (!filled.empty()) {
    interpolate(hits, filled);
  }
  return int(filled.size());
}

}  // namespace morphgrid
