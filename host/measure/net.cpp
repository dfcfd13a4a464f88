#include "measure/net.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Steps in which blends are tried: the strut ratio need not fall all the way to the isolines.
constexpr int kBlendSteps = 32;
constexpr int kBisections = 20;

Net blended(const Net& net, const Net& isolines, double share) {
  return {net.nodesU, net.nodesV, (1 - share) * net.parameters + share * isolines.parameters,
          net.followsIsolines};
}

double area(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Counts what chords there are.
struct ChordRange {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;

  void add(const Vector3d& chord) {
    shortest = std::min(shortest, chord.norm());
    longest = std::max(longest, chord.norm());
  }
};

ChordRange chordsOf(const PointLattice& points) {
  ChordRange chords;
  for (int j = 0; j < points.countV; ++j) {
    for (int i = 0; i < points.countU; ++i) {
      if (i + 1 < points.countU) chords.add(points.at(i + 1, j) - points.at(i, j));
      if (j + 1 < points.countV) chords.add(points.at(i, j + 1) - points.at(i, j));
    }
  }
  return chords;
}

double strutRatio(const PointLattice& points) {
  const ChordRange chords = chordsOf(points);
  return chords.longest / chords.shortest;
}

double angleDeviation(const Vector3d& a, const Vector3d& b) {
  return std::abs(std::atan2(a.cross(b).norm(), a.dot(b)) - std::numbers::pi / 2);
}

}  // namespace

Net isolineNet(int nodesU, int nodesV) {
  Net net{nodesU, nodesV, Eigen::Matrix2Xd(2, (nodesU + 1) * (nodesV + 1)), true};
  forEachVertex(net.shape(), [&](const GridPlace& place) {
    net.parameters.col(net.shape().index(place)) << double(place.i) / nodesU,
        double(place.j) / nodesV;
  });
  return net;
}

void requireUnfolded(const Net& net) {
  forEachCell(net.shape(), [&](const Cell& cell) {
    const std::array<int, 4> ring = cell.ring();
    for (int corner = 0; corner < 4; ++corner) {
      const Vector2d here = net.parameters.col(ring[corner]);
      const Vector2d next = net.parameters.col(ring[(corner + 1) % 4]);
      const Vector2d previous = net.parameters.col(ring[(corner + 3) % 4]);
      if (!(area(next - here, previous - here) > 0)) {
        throw InputError(fmt::format(
            "the net of lines is folded in node ({}, {}), at u = {:.4g}, v = {:.4g} of [0, 1]: "
            "the surface is too rough or its sides too skew there; take design.net = "
            "\"isoline\", or a smoother surface",
            cell.place.i, cell.place.j, here.x(), here.y()));
      }
    }
  });
}

NetQuality assessNet(const PointLattice& points) {
  double sum = 0;
  double largest = 0;
  const int nodesU = points.countU - 1;
  const int nodesV = points.countV - 1;
  for (int j = 0; j < nodesV; ++j) {
    for (int i = 0; i < nodesU; ++i) {
      const Vector3d corners[] = {points.at(i, j), points.at(i + 1, j), points.at(i + 1, j + 1),
                                  points.at(i, j + 1)};
      for (int corner = 0; corner < 4; ++corner) {
        const Vector3d& here = corners[corner];
        const double deviation =
            angleDeviation(corners[(corner + 1) % 4] - here, corners[(corner + 3) % 4] - here);
        sum += deviation;
        largest = std::max(largest, deviation);
      }
    }
  }
  return {strutRatio(points), sum / (4.0 * nodesU * nodesV), largest};
}

BlendedNet boundStrutRatio(const Net& net, double maxRatio, const NetPoints& pointsOf) {
  const Net isolines = isolineNet(net.nodesU, net.nodesV);
  const auto ratioAt = [&](double share) {
    return strutRatio(pointsOf(blended(net, isolines, share)));
  };
  double best = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (int step = 0; step <= kBlendSteps; ++step) {
    double share = double(step) / kBlendSteps;
    const double ratio = ratioAt(share);
    if (ratio < smallest) {
      smallest = ratio;
      best = share;
    }
    if (ratio <= maxRatio) {
      double tooLittle = std::max(0.0, double(step - 1) / kBlendSteps);
      for (int k = 0; step > 0 && k < kBisections; ++k) {
        const double middle = (tooLittle + share) / 2;
        (ratioAt(middle) <= maxRatio ? share : tooLittle) = middle;
      }
      best = share;
      break;
    }
  }
  return {blended(net, isolines, best), best};
}

}  // namespace morphgrid
