#include "render/sampling_layout.h"

#include <vector>

namespace morphgrid {
namespace {

Eigen::AlignedBox1d depthOf(const TriangleMesh& mesh, const RayHits& hits) {
  Eigen::AlignedBox1d depth;
  for (Eigen::Index ray = 0; ray < hits.points.cols(); ++ray) {
    if (hits.hit[ray] != 0) {
      depth.extend(hits.points.col(ray).head<1>());
    }
  }
  if (depth.isEmpty()) {
    const Eigen::AlignedBox3d whole = boundingBox(mesh);
    depth = {whole.min().head<1>(), whole.max().head<1>()};
  }
  return depth;
}

Eigen::Matrix3Xd columnsOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd columns(3, points.size());
  for (std::size_t n = 0; n < points.size(); ++n) {
    columns.col(static_cast<Eigen::Index>(n)) = points[n];
  }
  return columns;
}

/// The sum of the places of missed rays, and how many they are.
struct MissedRays {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
};

MissedRays missedIn(const RayHits& hits, const Eigen::AlignedBox2i& cell) {
  MissedRays missed;
  for (int j = cell.min().y(); j <= cell.max().y(); ++j) {
    for (int i = cell.min().x(); i <= cell.max().x(); ++i) {
      if (hits.hit[hits.index(i, j)] == 0) {
        missed.sum += hits.points.col(hits.index(i, j)).tail<2>();
        ++missed.count;
      }
    }
  }
  return missed;
}

}  // namespace

SamplingLayout layOutSampling(const TriangleMesh& mesh, const RayHits& hits) {
  const SamplingBox& box = hits.box;
  const Eigen::AlignedBox1d depth = depthOf(mesh, hits);
  const DrawnIsolines columns(hits.countU);
  const DrawnIsolines rows(hits.countV);
  const double stepU = box.uLength / (hits.countU - 1);
  const double stepV = box.vLength / (hits.countV - 1);
  return {{Eigen::Vector3d(depth.min().x(), box.uStart, box.vStart),
           Eigen::Vector3d(depth.max().x(), box.uStart + box.uLength, box.vStart + box.vLength)},
          columns,
          rows,
          std::min(stepU, stepV),
          std::min(columns.stride * stepU, rows.stride * stepV)};
}

Camera frameRays(const TriangleMesh& mesh, const RayHits& hits, double aspect) {
  const Eigen::AlignedBox3d sampled = layOutSampling(mesh, hits).sampled;
  const Eigen::AlignedBox3d whole = boundingBox(mesh);
  Eigen::Matrix3Xd points(3, 10);
  for (int corner = 0; corner < 8; ++corner) {
    points.col(corner) = sampled.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
  }
  // In the middle of the picture, so that only the depth grows.
  points.rightCols<2>().colwise() = sampled.center();
  points(0, 8) = whole.min().x();
  points(0, 9) = whole.max().x();
  return frameAll(points, kRayView.direction, kRayView.up, aspect);
}

Eigen::Matrix3Xd crossingHits(const SamplingLayout& layout, const RayHits& hits) {
  std::vector<Eigen::Vector3d> points;
  for (int row = 0; row < layout.rows.count; ++row) {
    for (int column = 0; column < layout.columns.count; ++column) {
      const int ray = hits.index(layout.columns.at(column), layout.rows.at(row));
      if (hits.hit[ray] != 0) {
        points.emplace_back(hits.points.col(ray));
      }
    }
  }
  return columnsOf(points);
}

Eigen::Matrix3Xd missedMarks(const SamplingLayout& layout, const RayHits& hits) {
  const int strideU = layout.columns.stride;
  const int strideV = layout.rows.stride;
  std::vector<Eigen::Vector3d> marks;
  for (int j = 0; j < hits.countV; j += strideV) {
    for (int i = 0; i < hits.countU; i += strideU) {
      const Eigen::Vector2i last(std::min(i + strideU, hits.countU) - 1,
                                 std::min(j + strideV, hits.countV) - 1);
      const MissedRays missed = missedIn(hits, {Eigen::Vector2i(i, j), last});
      if (missed.count > 0) {
        const Eigen::Vector2d middle = missed.sum / missed.count;
        marks.emplace_back(layout.sampled.center().x(), middle.x(), middle.y());
      }
    }
  }
  return columnsOf(marks);
}

}  // namespace morphgrid
