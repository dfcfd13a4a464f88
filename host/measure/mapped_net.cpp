#include "measure/mapped_net.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// How far beside a triangle, in nodes and in shares of the triangle, rounding may put a vertex.
constexpr double kTolerance = 1e-9;

/// Where along a side, in [0, 1], the map takes the value: the first place, should it turn back.
double placeOnSide(const Eigen::VectorXd& values, double value) {
  if (value <= 0 || value >= 1) return value;
  Eigen::Index k = 1;
  while (values[k] < value) ++k;  // The last one is 1.
  const double share = (value - values[k - 1]) / (values[k] - values[k - 1]);
  return (double(k - 1) + share) / double(values.size() - 1);
}

/// Finds the vertices between the sides: each triangle of the map is drawn onto the lattice of
/// (u, v) times the node counts, where vertices are the whole numbers.
class Rasteriser {
 public:
  Rasteriser(const LatticeMap& map, Net& net)
      : map_(map), net_(net), inside_(net.parameters.cols(), -1) {}

  void draw(const Eigen::Vector3i& triangle) {
    const Eigen::Matrix<double, 2, 3> corners =
        Vector2d(net_.nodesU, net_.nodesV).asDiagonal() * map_.values(Eigen::all, triangle);
    const Vector2d origin = corners.col(0);
    Eigen::Matrix2d sharesOf;
    bool invertible = false;
    (corners.rightCols<2>().colwise() - origin)
        .eval()
        .computeInverseWithCheck(sharesOf, invertible, 0);
    if (!invertible) return;
    const Vector2d low = corners.rowwise().minCoeff().array() - kTolerance;
    const Vector2d high = corners.rowwise().maxCoeff().array() + kTolerance;
    for (int j = firstWithin(low.y()); j <= lastWithin(high.y(), net_.nodesV); ++j) {
      for (int i = firstWithin(low.x()); i <= lastWithin(high.x(), net_.nodesU); ++i) {
        const Vector2d shares = sharesOf * (Vector2d(i, j) - origin);
        settle(net_.index(i, j), triangle, {1 - shares.sum(), shares.x(), shares.y()});
      }
    }
  }

 private:
  static int firstWithin(double low) { return std::max(1, static_cast<int>(std::ceil(low))); }
  static int lastWithin(double high, int nodes) {
    return std::min(nodes - 1, static_cast<int>(std::floor(high)));
  }

  /// Where several triangles meet, or overlap in a fold, the one deepest inside counts.
  void settle(int vertex, const Eigen::Vector3i& triangle, const Vector3d& shares) {
    const double inside = shares.minCoeff();
    if (inside < -kTolerance || inside <= inside_[vertex]) return;
    inside_[vertex] = inside;
    Vector2d parameters(0, 0);
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::Vector2i place(triangle[corner] % map_.countU, triangle[corner] / map_.countU);
      parameters += shares[corner] * place.cast<double>();
    }
    net_.parameters.col(vertex) =
        parameters.cwiseQuotient(Vector2d(map_.countU - 1, map_.countV - 1));
  }

  const LatticeMap& map_;
  Net& net_;
  std::vector<double> inside_;  ///< Smallest barycentric coordinate so far.
};

void placeSides(const LatticeMap& map, Net& net) {
  const auto alongU = [&](int j) {
    return map.values.row(0).segment(Eigen::Index(j) * map.countU, map.countU).transpose().eval();
  };
  const auto alongV = [&](int i) {
    return Eigen::VectorXd::NullaryExpr(
               map.countV, [&](Eigen::Index j) { return map.values(1, j * map.countU + i); })
        .eval();
  };
  for (const int end : {0, 1}) {
    const Eigen::VectorXd rowValues = alongU(end * (map.countV - 1));
    for (int i = 0; i <= net.nodesU; ++i) {
      net.parameters.col(net.index(i, end * net.nodesV))
          << placeOnSide(rowValues, double(i) / net.nodesU),
          end;
    }
    const Eigen::VectorXd columnValues = alongV(end * (map.countU - 1));
    for (int j = 0; j <= net.nodesV; ++j) {
      net.parameters.col(net.index(end * net.nodesU, j)) << end,
          placeOnSide(columnValues, double(j) / net.nodesV);
    }
  }
}

}  // namespace

Net mappedNet(const LatticeMap& map, int nodesU, int nodesV) {
  // The triangles cover the square, so every vertex is found; NaN would be reported as a fold.
  Net net{nodesU, nodesV, Eigen::Matrix2Xd::Constant(2, (nodesU + 1) * (nodesV + 1), std::nan(""))};
  Rasteriser rasteriser(map, net);
  for (const auto& triangle : map.triangles.colwise()) {
    rasteriser.draw(triangle);
  }
  placeSides(map, net);
  requireUnfolded(net);
  return net;
}

}  // namespace morphgrid
