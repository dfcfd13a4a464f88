#include "measure/mesh_measurement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/error.h"
#include "measure/catmull_rom.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr int kSurveySamplesPerSegment = 10;
constexpr int kSamplesPerStrut = 100;

/// A line of the lattice, one column a segment.
struct Isoline {
  Eigen::RowVectorXd chords;
  Eigen::MatrixXd curvatures;  ///< Signed kappa, a row a sample; a single row when smoothed.

  Eigen::RowVectorXd meanCurvatures() const { return curvatures.colwise().mean(); }
};

/// Unit normals p_u x p_v at the hits: central differences, one-sided at the lattice's edges.
Matrix3Xd normalsOf(const RayHits& hits) {
  const auto point = [&](int i, int j) { return hits.points.col(hits.index(i, j)); };
  Matrix3Xd normals(3, hits.points.cols());
  for (int j = 0; j < hits.countV; ++j) {
    for (int i = 0; i < hits.countU; ++i) {
      const Vector3d alongU =
          point(std::min(i + 1, hits.countU - 1), j) - point(std::max(i - 1, 0), j);
      const Vector3d alongV =
          point(i, std::min(j + 1, hits.countV - 1)) - point(i, std::max(j - 1, 0));
      normals.col(hits.index(i, j)) = alongU.cross(alongV).normalized();
    }
  }
  return normals;
}

/// See the header: the Gaussian mean of the segments' means.
Eigen::RowVectorXd smoothedCurvatures(const Isoline& line, double width) {
  const Eigen::RowVectorXd means = line.meanCurvatures();
  Eigen::ArrayXd middles(means.size());
  double start = 0;
  for (Eigen::Index k = 0; k < means.size(); ++k) {
    middles[k] = start + line.chords[k] / 2;
    start += line.chords[k];
  }
  Eigen::RowVectorXd smoothed(means.size());
  for (Eigen::Index k = 0; k < means.size(); ++k) {
    // sigma = width / 2: d^2 / (2 sigma^2) = 2 (d / width)^2.
    const Eigen::VectorXd weights =
        line.chords.transpose().array() * (-2 * ((middles - middles[k]) / width).square()).exp();
    smoothed[k] = means.dot(weights) / weights.sum();
  }
  return smoothed;
}

/// The isolines of a lattice of hits.
class Isolines {
 public:
  Isolines(const RayHits& hits, int samplesPerSegment, double smoothingWidth)
      : hits_(hits),
        normals_(normalsOf(hits)),
        samples_(samplesPerSegment),
        smoothingWidth_(smoothingWidth) {
    assert(hits.countU >= 2 && hits.countV >= 2);
    assert(std::all_of(hits.hit.begin(), hits.hit.end(), [](char hit) { return hit != 0; }));
  }

  Isoline alongU(int j) const { return walk(hits_.index(0, j), hits_.countU, 1); }
  Isoline alongV(int i) const { return walk(hits_.index(i, 0), hits_.countV, hits_.countU); }

 private:
  Isoline walk(int first, int count, int step) const {
    const auto columns = Eigen::seqN(first, count, step);
    const Matrix3Xd points = hits_.points(Eigen::all, columns);
    const Matrix3Xd normals = normals_(Eigen::all, columns);
    Isoline line{(points.rightCols(count - 1) - points.leftCols(count - 1)).colwise().norm(),
                 sampleCurvatures(points, normals)};
    requireLengths(line, points);
    if (smoothingWidth_ > 0) {
      line.curvatures = smoothedCurvatures(line, smoothingWidth_);
    }
    return line;
  }

  Eigen::MatrixXd sampleCurvatures(const Matrix3Xd& points, const Matrix3Xd& normals) const {
    const CatmullRomSpline spline(points);
    Eigen::MatrixXd curvatures(samples_, spline.segmentCount());
    for (int segment = 0; segment < spline.segmentCount(); ++segment) {
      const Vector3d normal = normals.col(segment) + normals.col(segment + 1);
      for (int sample = 0; sample < samples_; ++sample) {
        curvatures(sample, segment) = spline.curvature(segment, (sample + 0.5) / samples_, normal);
      }
    }
    return curvatures;
  }

  /// Rays are apart, so only rounding brings their hits together.
  static void requireLengths(const Isoline& line, const Matrix3Xd& points) {
    Eigen::Index segment = 0;
    if (!(line.chords.minCoeff(&segment) > 0)) {
      throw InputError(fmt::format(
          "neighbouring rays hit the same point, u = {}, v = {}: the box is too small for numbers "
          "of this size, or has too many samples",
          points(1, segment), points(2, segment)));
    }
  }

  const RayHits& hits_;
  Matrix3Xd normals_;
  int samples_;
  double smoothingWidth_;
};

/// What a survey gathers from all isolines.
struct CurvatureSamples {
  std::vector<double> magnitudes;   ///< |kappa|
  std::vector<double> differences;  ///< Between neighbouring segments.
};

void add(const Isoline& line, DirectionSurvey& direction, CurvatureSamples& samples) {
  direction.longestIsoline = std::max(direction.longestIsoline, line.chords.sum());
  for (const double curvature : line.curvatures.reshaped()) {
    direction.largestCurvature = std::max(direction.largestCurvature, std::abs(curvature));
    samples.magnitudes.push_back(std::abs(curvature));
  }
  const Eigen::RowVectorXd means = line.meanCurvatures();
  for (Eigen::Index k = 1; k < means.size(); ++k) {
    samples.differences.push_back(std::abs(means[k] - means[k - 1]));
  }
}

/// The upper one of the two in the middle of an even number; 0 of none.
double median(std::vector<double> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Eigen::RowVectorXd cappedMeans(const Isoline& line, double limit) {
  return line.meanCurvatures().cwiseMax(-limit).cwiseMin(limit);
}

}  // namespace

MeshSurvey surveyMesh(const RayHits& hits, double smoothingWidth) {
  const Isolines isolines(hits, kSurveySamplesPerSegment, smoothingWidth);
  DirectionSurvey u;
  DirectionSurvey v;
  CurvatureSamples samples;
  for (int j = 0; j < hits.countV; ++j) {
    add(isolines.alongU(j), u, samples);
  }
  for (int i = 0; i < hits.countU; ++i) {
    add(isolines.alongV(i), v, samples);
  }
  return {makeSurvey(u, v, std::move(samples.magnitudes)), median(std::move(samples.differences))};
}

SurfaceMeasurement measureMesh(const RayHits& hits, double curvatureLimit, double smoothingWidth) {
  const int nodesU = hits.countU - 1;
  const int nodesV = hits.countV - 1;
  const Isolines isolines(hits, kSamplesPerStrut, smoothingWidth);
  SurfaceMeasurement measurement{nodesU, nodesV, LateralField<double>(nodesU, nodesV),
                                 LateralField<double>(nodesU, nodesV), hits.points};
  for (int j = 0; j <= nodesV; ++j) {
    const Isoline line = isolines.alongU(j);
    const Eigen::RowVectorXd curvatures = cappedMeans(line, curvatureLimit);
    for (int i = 0; i < nodesU; ++i) {
      measurement.chords.u(i, j) = line.chords[i];
      measurement.curvatures.u(i, j) = curvatures[i];
    }
  }
  for (int i = 0; i <= nodesU; ++i) {
    const Isoline line = isolines.alongV(i);
    const Eigen::RowVectorXd curvatures = cappedMeans(line, curvatureLimit);
    for (int j = 0; j < nodesV; ++j) {
      measurement.chords.v(i, j) = line.chords[j];
      measurement.curvatures.v(i, j) = curvatures[j];
    }
  }
  return measurement;
}

}  // namespace morphgrid
