#include "measure/lattice_measurement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/error.h"
#include "core/parallel_for.h"
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

/// Unit normals p_u x p_v: central differences, one-sided at the lattice's edges.
Matrix3Xd normalsOf(const PointLattice& lattice) {
  const auto point = [&](int i, int j) { return lattice.points.col(lattice.index(i, j)); };
  Matrix3Xd normals(3, lattice.points.cols());
  for (int j = 0; j < lattice.countV; ++j) {
    for (int i = 0; i < lattice.countU; ++i) {
      const Vector3d alongU =
          point(std::min(i + 1, lattice.countU - 1), j) - point(std::max(i - 1, 0), j);
      const Vector3d alongV =
          point(i, std::min(j + 1, lattice.countV - 1)) - point(i, std::max(j - 1, 0));
      normals.col(lattice.index(i, j)) = alongU.cross(alongV).normalized();
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

template <typename Work>
void forEachLine(int count, const Work& work) {
  constexpr int kLinesPerRange = 4;
  parallelFor(count, kLinesPerRange, [&](Eigen::Index line) { work(static_cast<int>(line)); });
}

/// The lines of a lattice.
class Isolines {
 public:
  Isolines(const PointLattice& lattice, int samplesPerSegment, double smoothingWidth,
           const Cancellation& cancellation)
      : lattice_(lattice),
        normals_(normalsOf(lattice)),
        samples_(samplesPerSegment),
        smoothingWidth_(smoothingWidth),
        cancellation_(cancellation) {
    assert(lattice.countU >= 2 && lattice.countV >= 2);
  }

  Isoline alongU(int j) const { return walk(lattice_.index(0, j), lattice_.countU, 1); }
  Isoline alongV(int i) const {
    return walk(lattice_.index(i, 0), lattice_.countV, lattice_.countU);
  }

  std::vector<Isoline> allAlongU() const {
    std::vector<Isoline> lines(static_cast<std::size_t>(lattice_.countV));
    forEachLine(lattice_.countV, [&](int j) { lines[static_cast<std::size_t>(j)] = alongU(j); });
    return lines;
  }
  std::vector<Isoline> allAlongV() const {
    std::vector<Isoline> lines(static_cast<std::size_t>(lattice_.countU));
    forEachLine(lattice_.countU, [&](int i) { lines[static_cast<std::size_t>(i)] = alongV(i); });
    return lines;
  }

 private:
  Isoline walk(int first, int count, int step) const {
    cancellation_.check();
    const auto columns = Eigen::seqN(first, count, step);
    const Matrix3Xd points = lattice_.points(Eigen::all, columns);
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

  static void requireLengths(const Isoline& line, const Matrix3Xd& points) {
    Eigen::Index segment = 0;
    if (!(line.chords.minCoeff(&segment) > 0)) {
      throw InputError(fmt::format(
          "neighbouring points coincide at ({}, {}, {}): the box is too small for numbers of this "
          "size, there are too many samples, or the surface is collapsed there",
          points(0, segment), points(1, segment), points(2, segment)));
    }
  }

  const PointLattice& lattice_;
  Matrix3Xd normals_;
  int samples_;
  double smoothingWidth_;
  const Cancellation& cancellation_;
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

LatticeSurvey surveyLattice(const PointLattice& lattice, double smoothingWidth,
                            const Cancellation& cancellation) {
  const Isolines isolines(lattice, kSurveySamplesPerSegment, smoothingWidth, cancellation);
  DirectionSurvey u;
  DirectionSurvey v;
  CurvatureSamples samples;
  for (const Isoline& line : isolines.allAlongU()) add(line, u, samples);
  for (const Isoline& line : isolines.allAlongV()) add(line, v, samples);
  return {makeSurvey(u, v, std::move(samples.magnitudes)), median(std::move(samples.differences))};
}

SurfaceMeasurement measureLattice(const PointLattice& lattice, double curvatureLimit,
                                  double smoothingWidth, const Cancellation& cancellation) {
  const int nodesU = lattice.countU - 1;
  const int nodesV = lattice.countV - 1;
  const Isolines isolines(lattice, kSamplesPerStrut, smoothingWidth, cancellation);
  SurfaceMeasurement measurement{nodesU, nodesV, LateralField<double>(nodesU, nodesV),
                                 LateralField<double>(nodesU, nodesV), lattice.points};
  LateralField<double>& chords = measurement.chords;
  LateralField<double>& curvatures = measurement.curvatures;
  forEachLine(nodesV + 1, [&](int j) {
    const Isoline line = isolines.alongU(j);
    const Eigen::RowVectorXd means = cappedMeans(line, curvatureLimit);
    for (int i = 0; i < nodesU; ++i) {
      chords.u(i, j) = line.chords[i];
      curvatures.u(i, j) = means[i];
    }
  });
  forEachLine(nodesU + 1, [&](int i) {
    const Isoline line = isolines.alongV(i);
    const Eigen::RowVectorXd means = cappedMeans(line, curvatureLimit);
    for (int j = 0; j < nodesV; ++j) {
      chords.v(i, j) = line.chords[j];
      curvatures.v(i, j) = means[j];
    }
  });
  return measurement;
}

}  // namespace morphgrid
