#include "measure/surface_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "grid/strut_grid.h"

namespace morphgrid {
namespace {

constexpr int kSurveyIsolines = 100;
constexpr int kSurveySamples = 1000;
constexpr int kCurvatureSamplesPerStrut = 100;

enum class Direction { u, v };

/// Isolines along u run over t at fixed v = s; along v the other way round.
Eigen::Vector3d pointOn(const Surface& surface, Direction along, double t, double s) {
  return along == Direction::u ? surface.point(t, s) : surface.point(s, t);
}

double curvatureOn(const Surface& surface, Direction along, double t, double s) {
  return along == Direction::u ? surface.curvatureAlongU(t, s) : surface.curvatureAlongV(s, t);
}

DirectionSurvey surveyDirection(const Surface& surface, Direction along,
                                const Cancellation& cancellation, std::vector<double>& curvatures) {
  DirectionSurvey survey;
  for (int line = 0; line < kSurveyIsolines; ++line) {
    cancellation.check();
    const double s = double(line) / (kSurveyIsolines - 1);
    double length = 0;
    Eigen::Vector3d previous = pointOn(surface, along, 0, s);
    for (int sample = 0; sample < kSurveySamples; ++sample) {
      const double t = double(sample) / (kSurveySamples - 1);
      const Eigen::Vector3d current = pointOn(surface, along, t, s);
      length += (current - previous).norm();
      previous = current;
      const double curvature = std::abs(curvatureOn(surface, along, t, s));
      survey.largestCurvature = std::max(survey.largestCurvature, curvature);
      curvatures.push_back(curvature);
    }
    survey.longestIsoline = std::max(survey.longestIsoline, length);
  }
  return survey;
}

/// Mean of the capped curvature over the strut from t0 to t1.
double meanCurvature(const Surface& surface, Direction along, double t0, double t1, double s,
                     double limit) {
  double sum = 0;
  for (int sample = 0; sample < kCurvatureSamplesPerStrut; ++sample) {
    const double share = (sample + 0.5) / kCurvatureSamplesPerStrut;
    sum += std::clamp(curvatureOn(surface, along, t0 + share * (t1 - t0), s), -limit, limit);
  }
  return sum / kCurvatureSamplesPerStrut;
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
  std::vector<double> curvatures;
  curvatures.reserve(2 * kSurveyIsolines * kSurveySamples);
  const DirectionSurvey u = surveyDirection(surface, Direction::u, cancellation, curvatures);
  const DirectionSurvey v = surveyDirection(surface, Direction::v, cancellation, curvatures);
  return makeSurvey(u, v, std::move(curvatures));
}

double curvatureAtCutoff(const SurfaceSurvey& survey, double cutoff) {
  const auto last = static_cast<double>(survey.sortedCurvatures.size() - 1);
  return survey.sortedCurvatures[static_cast<std::size_t>(std::floor(last * cutoff))];
}

Eigen::Matrix3Xd pointsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters) {
  Eigen::Matrix3Xd points(3, parameters.cols());
  for (Eigen::Index n = 0; n < points.cols(); ++n) {
    points.col(n) = surface.point(parameters(0, n), parameters(1, n));
  }
  return points;
}

Eigen::Matrix3Xd normalsAt(const Surface& surface, const Eigen::Matrix2Xd& parameters) {
  Eigen::Matrix3Xd normals(3, parameters.cols());
  for (Eigen::Index n = 0; n < normals.cols(); ++n) {
    normals.col(n) = surface.normal(parameters(0, n), parameters(1, n));
  }
  return normals;
}

SurfaceMeasurement measureSurface(const Surface& surface, int nodesU, int nodesV,
                                  double curvatureLimit, const Cancellation& cancellation) {
  SurfaceMeasurement measurement{nodesU, nodesV, LateralField<double>(nodesU, nodesV),
                                 LateralField<double>(nodesU, nodesV),
                                 Eigen::Matrix3Xd(3, (nodesU + 1) * (nodesV + 1))};
  Eigen::Matrix3Xd& points = measurement.points;
  const GridShape layer = measurement.chords.shape();
  const auto parameterU = [&](int i) { return double(i) / nodesU; };
  const auto parameterV = [&](int j) { return double(j) / nodesV; };
  forEachVertex(layer, [&](const GridPlace& place) {
    points.col(layer.index(place)) = surface.point(parameterU(place.i), parameterV(place.j));
  });
  forEachLateralStrut(layer, [&](const Strut& strut) {
    cancellation.check();
    const auto [i, j, bottom] = layer.place(strut.from);
    measurement.chords.at(strut) = lengthAt(points, strut);
    measurement.curvatures.at(strut) =
        strut.direction == Strut::Direction::u
            ? meanCurvature(surface, Direction::u, parameterU(i), parameterU(i + 1), parameterV(j),
                            curvatureLimit)
            : meanCurvature(surface, Direction::v, parameterV(j), parameterV(j + 1), parameterU(i),
                            curvatureLimit);
  });
  return measurement;
}

}  // namespace morphgrid
