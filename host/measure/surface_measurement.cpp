#include "measure/surface_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel_for.h"
#include "grid/strut_grid.h"
#include "measure/net.h"

namespace morphgrid {
namespace {

constexpr int kSurveyIsolines = 100;
constexpr int kSurveySamples = 1000;
constexpr int kSamplesPerStrut = 100;
// An isoline of many struts has no use for as many samples each: with so many it is sampled several
// times as finely as one of the paper's grids.
constexpr int kMostSamplesPerIsoline = 10000;
constexpr int kFewestSamplesPerStrut = 8;
constexpr int kIsolinesPerRange = 4;
constexpr int kPointsPerRange = 4096;

enum class Direction { u, v };

/// Isolines along u run over t at fixed v = s; along v the other way round.
Eigen::Vector3d pointOn(const Surface& surface, Direction along, double t, double s) {
  return along == Direction::u ? surface.point(t, s) : surface.point(s, t);
}

Eigen::ArrayXd curvaturesOn(const Surface& surface, Direction along, const Eigen::ArrayXd& t,
                            double s) {
  return along == Direction::u ? surface.curvaturesAlongU(t, s) : surface.curvaturesAlongV(s, t);
}

double lengthOf(const Surface& surface, Direction along, const Eigen::ArrayXd& t, double s) {
  double length = 0;
  Eigen::Vector3d previous = pointOn(surface, along, t[0], s);
  for (const double place : t) {
    const Eigen::Vector3d current = pointOn(surface, along, place, s);
    length += (current - previous).norm();
    previous = current;
  }
  return length;
}

DirectionSurvey surveyDirection(const Surface& surface, Direction along,
                                const Cancellation& cancellation,
                                Eigen::Ref<Eigen::ArrayXXd> curvatures) {
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(kSurveySamples, 0, 1);
  Eigen::ArrayXd lengths(kSurveyIsolines);
  parallelFor(kSurveyIsolines, kIsolinesPerRange, [&](Eigen::Index line) {
    cancellation.check();
    const double s = double(line) / (kSurveyIsolines - 1);
    lengths[line] = lengthOf(surface, along, t, s);
    curvatures.col(line) = curvaturesOn(surface, along, t, s).abs();
  });
  return {lengths.maxCoeff(), curvatures.maxCoeff()};
}

/// Of each of `count` struts of an isoline the mean of the capped curvature.
Eigen::ArrayXd meanCurvatures(const Surface& surface, Direction along, int count, double s,
                              double limit) {
  const Eigen::Index perStrut =
      std::clamp(kMostSamplesPerIsoline / count, kFewestSamplesPerStrut, kSamplesPerStrut);
  const Eigen::Index samples = perStrut * count;
  const Eigen::ArrayXd t =
      (Eigen::ArrayXd::LinSpaced(samples, 0, double(samples - 1)) + 0.5) / double(samples);
  const Eigen::ArrayXd capped = curvaturesOn(surface, along, t, s).max(-limit).min(limit);
  return capped.reshaped(perStrut, count).colwise().mean().transpose();
}

}  // namespace

SurfaceSurvey makeSurvey(const DirectionSurvey& u, const DirectionSurvey& v,
                         std::vector<double> curvatures) {
  if (!(u.longestIsoline > 0 && v.longestIsoline > 0)) {
    throw InputError(fmt::format("the surface must have an extent along u and v, got {} and {}",
                                 u.longestIsoline, v.longestIsoline));
  }
  std::sort(curvatures.begin(), curvatures.end());
  return {u.longestIsoline, v.longestIsoline, u.largestCurvature, v.largestCurvature,
          std::move(curvatures)};
}

SurfaceSurvey surveySurface(const Surface& surface, const Cancellation& cancellation) {
  std::vector<double> curvatures(2 * kSurveyIsolines * kSurveySamples);
  Eigen::Map<Eigen::ArrayXXd> samples(curvatures.data(), kSurveySamples, 2 * kSurveyIsolines);
  const DirectionSurvey u =
      surveyDirection(surface, Direction::u, cancellation, samples.leftCols(kSurveyIsolines));
  const DirectionSurvey v =
      surveyDirection(surface, Direction::v, cancellation, samples.rightCols(kSurveyIsolines));
  return makeSurvey(u, v, std::move(curvatures));
}

double curvatureAtCutoff(const SurfaceSurvey& survey, double cutoff) {
  const auto last = static_cast<double>(survey.sortedCurvatures.size() - 1);
  return survey.sortedCurvatures[static_cast<std::size_t>(std::floor(last * cutoff))];
}

Eigen::Matrix3Xd pointsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters) {
  Eigen::Matrix3Xd points(3, parameters.cols());
  parallelFor(points.cols(), kPointsPerRange, [&](Eigen::Index n) {
    points.col(n) = surface.point(parameters(0, n), parameters(1, n));
  });
  return points;
}

Eigen::Matrix3Xd normalsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters) {
  Eigen::Matrix3Xd normals(3, parameters.cols());
  parallelFor(normals.cols(), kPointsPerRange, [&](Eigen::Index n) {
    normals.col(n) = surface.normal(parameters(0, n), parameters(1, n));
  });
  return normals;
}

SurfaceMeasurement measureSurface(const Surface& surface, int nodesU, int nodesV,
                                  double curvatureLimit, const Cancellation& cancellation) {
  const Net net = isolineNet(nodesU, nodesV);
  SurfaceMeasurement measurement{nodesU, nodesV, LateralField<double>(nodesU, nodesV),
                                 LateralField<double>(nodesU, nodesV),
                                 pointsAt(surface, net.parameters)};
  forEachLateralStrut(net.shape(), [&](const Strut& strut) {
    measurement.chords.at(strut) = lengthAt(measurement.points, strut);
  });
  LateralField<double>& curvatures = measurement.curvatures;
  parallelFor(nodesV + 1, kIsolinesPerRange, [&](Eigen::Index j) {
    cancellation.check();
    const Eigen::ArrayXd means =
        meanCurvatures(surface, Direction::u, nodesU, double(j) / nodesV, curvatureLimit);
    for (int i = 0; i < nodesU; ++i) curvatures.u(i, static_cast<int>(j)) = means[i];
  });
  parallelFor(nodesU + 1, kIsolinesPerRange, [&](Eigen::Index i) {
    cancellation.check();
    const Eigen::ArrayXd means =
        meanCurvatures(surface, Direction::v, nodesV, double(i) / nodesU, curvatureLimit);
    for (int j = 0; j < nodesV; ++j) curvatures.v(static_cast<int>(i), j) = means[j];
  });
  return measurement;
}

}  // namespace morphgrid
