#include "layout/coarse_sheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unsupported/Eigen/Splines>

namespace morphgrid {
namespace {

using Eigen::Matrix2Xd;

constexpr int kSplineDegree = 3;
// Along each direction, so that splines have their degree.
constexpr int kFewestLines = kSplineDegree + 1;

/// Every 1 / share of the vertices, first and last among them.
std::vector<int> chosenLines(int vertices, double share) {
  const int count = std::clamp(static_cast<int>(std::lround(share * vertices)),
                               std::min(kFewestLines, vertices), vertices);
  std::vector<int> lines;
  for (int n = 0; n < count; ++n) {
    lines.push_back(
        static_cast<int>(std::lround(static_cast<double>(n) * (vertices - 1) / (count - 1))));
  }
  return lines;
}

/// Points where the finer lines run of the spline through `points`, a column for each of the lines.
Matrix2Xd alongSpline(const Matrix2Xd& points, const std::vector<double>& lines,
                      const std::vector<double>& finer) {
  using Spline = Eigen::Spline<double, 2, kSplineDegree>;
  const double last = lines.back();  // Splines have their parameters in [0, 1].
  Spline::KnotVectorType knots(lines.size());
  std::transform(lines.begin(), lines.end(), knots.begin(),
                 [&](double line) { return line / last; });
  const Spline spline = Eigen::SplineFitting<Spline>::Interpolate(points, kSplineDegree, knots);
  Matrix2Xd result(2, finer.size());
  std::transform(finer.begin(), finer.end(), result.colwise().begin(),
                 [&](double line) -> Eigen::Vector2d { return spline(line / last); });
  return result;
}

std::vector<double> at(const std::vector<double>& values, const std::vector<int>& indices) {
  std::vector<double> result;
  for (const int index : indices) result.push_back(values[index]);
  return result;
}

std::vector<double> counted(int count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

NetLines evenLines(const GridShape& layer) {
  return {counted(layer.verticesU), counted(layer.verticesV)};
}

CoarseSheetProblem::CoarseSheetProblem(const SheetProblem& fine, const NetLines& fineLines,
                                       int mostJoints)
    : fineLines_(fineLines) {
  const double share =
      std::min(0.5, std::sqrt(static_cast<double>(mostJoints) / fine.layer.layerVertexCount()));
  const std::vector<int> u = chosenLines(fine.layer.verticesU, share);
  const std::vector<int> v = chosenLines(fine.layer.verticesV, share);
  lines_ = {at(fineLines.u, u), at(fineLines.v, v)};
  const GridShape layer{static_cast<int>(u.size()), static_cast<int>(v.size()), 1};
  problem_ = {.layer = layer,
              .points = Eigen::Matrix3Xd(3, layer.layerVertexCount()),
              .normals = Eigen::Matrix3Xd(3, layer.layerVertexCount()),
              .rest = {fine.rest.size(), LateralField<double>(layer.cellsU(), layer.cellsV())},
              .shrink = fine.shrink};
  forEachVertex(layer, [&](const GridPlace& place) {
    const int from = fine.layer.index(u[place.i], v[place.j], 0);
    problem_.points.col(layer.index(place)) = fine.points.col(from);
    problem_.normals.col(layer.index(place)) = fine.normals.col(from);
  });
  for (std::size_t k = 0; k < fine.rest.size(); ++k) {
    forEachLateralStrut(layer, [&](const Strut& strut) {
      const GridPlace place = layer.place(strut.from);
      double length = 0;
      if (strut.direction == Strut::Direction::u) {
        for (int i = u[place.i]; i < u[place.i + 1]; ++i) {
          length += fine.rest[k].u(i, v[place.j]);
        }
      } else {
        for (int j = v[place.j]; j < v[place.j + 1]; ++j) {
          length += fine.rest[k].v(u[place.i], j);
        }
      }
      problem_.rest[k].at(strut) = length;
    });
  }
}

Matrix2Xd CoarseSheetProblem::prolong(const Matrix2Xd& positions) const {
  const GridShape& coarse = problem_.layer;
  const auto finerU = static_cast<Eigen::Index>(fineLines_.u.size());
  const auto finerV = static_cast<Eigen::Index>(fineLines_.v.size());
  Matrix2Xd rows(2, finerU * coarse.verticesV);
  for (int j = 0; j < coarse.verticesV; ++j) {
    rows.middleCols(j * finerU, finerU) = alongSpline(
        positions.middleCols(coarse.index(0, j, 0), coarse.verticesU), lines_.u, fineLines_.u);
  }
  Matrix2Xd result(2, finerU * finerV);
  for (Eigen::Index i = 0; i < finerU; ++i) {
    result(Eigen::all, Eigen::seqN(i, finerV, finerU)) = alongSpline(
        rows(Eigen::all, Eigen::seqN(i, coarse.verticesV, finerU)), lines_.v, fineLines_.v);
  }
  return result;
}

}  // namespace morphgrid
