#include "grid/surface_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <vector>

namespace morphgrid {
namespace {

using SparseWeights = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// A Catmull-Rom spline through `count` points, sampled `refine` times per segment: both matrices
/// are ((count-1) refine + 1) x count and map points to samples.
struct SplineSamples {
  SparseWeights position;
  SparseWeights derivative;  ///< Derivative by the parameter that runs from 0 to 1 in each segment.
};

/// Adds weight times the tangent at a point. The ends take the tangent of the parabola through the
/// last three points, so that the whole spline reproduces parabolas, like its interior.
void addTangent(Triplets& row, int sample, int count, int point, double weight) {
  const auto add = [&](int at, double share) { row.emplace_back(sample, at, weight * share); };
  const bool first = point == 0;
  if (!first && point != count - 1) {
    add(point - 1, -0.5);
    add(point + 1, 0.5);
  } else if (count == 2) {
    add(0, -1);
    add(1, 1);
  } else {
    const int inwards = first ? 1 : -1;
    add(point, -1.5 * inwards);
    add(point + inwards, 2 * inwards);
    add(point + 2 * inwards, -0.5 * inwards);
  }
}

void addHermite(Triplets& position, Triplets& derivative, int sample, int count, int segment,
                double t) {
  const double s = 1 - t;
  position.emplace_back(sample, segment, s * s * (1 + 2 * t));
  position.emplace_back(sample, segment + 1, t * t * (3 - 2 * t));
  addTangent(position, sample, count, segment, t * s * s);
  addTangent(position, sample, count, segment + 1, -t * t * s);
  derivative.emplace_back(sample, segment, -6 * t * s);
  derivative.emplace_back(sample, segment + 1, 6 * t * s);
  addTangent(derivative, sample, count, segment, s * (1 - 3 * t));
  addTangent(derivative, sample, count, segment + 1, t * (3 * t - 2));
}

SplineSamples sampleSpline(int count, int refine) {
  const int sampleCount = (count - 1) * refine + 1;
  Triplets position, derivative;
  for (int sample = 0; sample < sampleCount; ++sample) {
    const int segment = std::min(sample / refine, count - 2);
    const double t = static_cast<double>(sample - segment * refine) / refine;
    addHermite(position, derivative, sample, count, segment, t);
  }
  SplineSamples samples{{sampleCount, count}, {sampleCount, count}};
  samples.position.setFromTriplets(position.begin(), position.end());
  samples.derivative.setFromTriplets(derivative.begin(), derivative.end());
  return samples;
}

/// Applies weights along u and along v to each coordinate of a lattice; u runs fastest in both.
Eigen::Matrix3Xd apply(const SparseWeights& alongU, const SparseWeights& alongV,
                       const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd samples(3, alongU.rows() * alongV.rows());
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd values = points.row(axis);
    const Eigen::Map<const Eigen::MatrixXd> lattice(values.data(), alongU.cols(), alongV.cols());
    const Eigen::MatrixXd refinedU = alongU * lattice;
    const Eigen::MatrixXd refined = refinedU * alongV.transpose();
    samples.row(axis) = refined.reshaped().transpose();
  }
  return samples;
}

/// Sums of the area vectors of the cells around each vertex, each the cross product of the cell's
/// diagonals: unlike a triangle it keeps its direction when one side of the cell collapses.
Eigen::Matrix3Xd areaVectors(const GridShape& lattice, const Eigen::Matrix3Xd& vertices) {
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, vertices.cols());
  forEachCell(lattice, [&](const Cell& cell) {
    const Eigen::Vector3d rising =
        vertices.col(cell.vertex(1, 1)) - vertices.col(cell.vertex(0, 0));
    const Eigen::Vector3d falling =
        vertices.col(cell.vertex(0, 1)) - vertices.col(cell.vertex(1, 0));
    const Eigen::Vector3d area = rising.cross(falling);
    for (const int vertex : cell.vertices) {
      sums.col(vertex) += area;
    }
  });
  return sums;
}

/// Rounding errors give a zero tangent some direction; relative to the longest one they are small.
const double kNegligible = 1e-9;

/// The columns at unit length, zero where negligible beside the longest.
Eigen::Matrix3Xd directions(const Eigen::Matrix3Xd& tangents) {
  const Eigen::RowVectorXd lengths = tangents.colwise().stableNorm();
  const double shortest = kNegligible * lengths.maxCoeff();
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, tangents.cols());
  for (Eigen::Index i = 0; i < tangents.cols(); ++i) {
    if (lengths[i] > shortest) {
      result.col(i) = tangents.col(i).stableNormalized();
    }
  }
  return result;
}

/// Where a tangent vanishes or both are parallel (a pole, a fold) the cells around decide; where
/// they have no area either, +z is as good as any.
Eigen::Matrix3Xd computeNormals(const Eigen::Matrix3Xd& tangentsU,
                                const Eigen::Matrix3Xd& tangentsV, const Eigen::Matrix3Xd& areas) {
  const Eigen::Matrix3Xd u = directions(tangentsU);
  const Eigen::Matrix3Xd v = directions(tangentsV);
  Eigen::Matrix3Xd normals = directions(areas);
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const Eigen::Vector3d normal = u.col(i).cross(v.col(i));
    if (normal.norm() > kNegligible) {
      normals.col(i) = normal.normalized();
    } else if (normals.col(i).isZero()) {
      normals.col(i) = Eigen::Vector3d::UnitZ();
    }
  }
  return normals;
}

}  // namespace

Eigen::Matrix3Xi latticeTriangles(const GridShape& layer) {
  Eigen::Matrix3Xi triangles(3, 2 * layer.layerCellCount());
  int next = 0;
  forEachCell(layer, [&](const Cell& cell) {
    triangles.col(next++) << cell.vertex(0, 0), cell.vertex(1, 0), cell.vertex(1, 1);
    triangles.col(next++) << cell.vertex(0, 0), cell.vertex(1, 1), cell.vertex(0, 1);
  });
  return triangles;
}

SurfaceMesh tessellate(const GridShape& shape, const Eigen::Matrix3Xd& points, int refine) {
  assert(shape.verticesU >= 2 && shape.verticesV >= 2 && refine >= 1);
  assert(points.cols() == shape.layerVertexCount());
  const SplineSamples u = sampleSpline(shape.verticesU, refine);
  const SplineSamples v = sampleSpline(shape.verticesV, refine);
  const GridShape samples{static_cast<int>(u.position.rows()), static_cast<int>(v.position.rows()),
                          1};
  SurfaceMesh mesh;
  mesh.vertices = apply(u.position, v.position, points);
  mesh.normals =
      computeNormals(apply(u.derivative, v.position, points),
                     apply(u.position, v.derivative, points), areaVectors(samples, mesh.vertices));
  mesh.triangles = latticeTriangles(samples);
  return mesh;
}

}  // namespace morphgrid
