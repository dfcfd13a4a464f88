#include "benchmark/frame_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/bounding_diagonal.h"
#include "core/error.h"
#include "core/read_file.h"
#include "core/rigid_alignment.h"
#include "design/material.h"
#include "grid/bar_section.h"

namespace morphgrid {
namespace {

StrutGrid flatGrid(const nlohmann::json& file) {
  const GridShape shape{file.at("shape").at(0), file.at("shape").at(1), file.at("shape").at(2)};
  StrutGrid grid{shape,
                 file.at("spacing"),
                 Eigen::Matrix3Xd(3, shape.vertexCount()),
                 StrutValues(shape),
                 StrutValues(shape),
                 {}};
  const double layerSpacing = file.at("layerSpacing");
  const auto& printed = file.at("printed");
  forEachVertex(shape, [&](const GridPlace& place) {
    const int column = shape.index(place.i, place.j, 0);
    grid.positions.col(shape.index(place)) << double(printed.at(2 * column)),
        double(printed.at(2 * column + 1)), layerSpacing * place.layer;
  });
  std::size_t n = 0;
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = file.at("rest").at(n++);
    valueAt(grid.stiffness, strut) = strut.isLateral() ? kLateralWeight : kVerticalWeight;
  });
  return grid;
}

FrameReference::Answer answerOf(const nlohmann::json& json, int vertexCount) {
  const auto values = json.at("positions").get<std::vector<double>>();
  if (values.size() != 3 * static_cast<std::size_t>(vertexCount)) {
    throw InputError(fmt::format("{} coordinates for {} joints", values.size(), vertexCount));
  }
  FrameReference::Answer answer{json.at("thickness"), std::nullopt,
                                Eigen::Matrix3Xd::Map(values.data(), 3, vertexCount)};
  if (json.contains("energy")) {
    answer.energy = json.at("energy").get<double>();
  }
  return answer;
}

}  // namespace

double FrameReference::meanLateralRest() const {
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  return sum / grid.shape.lateralStrutCount();
}

const FrameReference::Answer& FrameReference::answerAt(double thickness) const {
  const auto found = std::find_if(answers.begin(), answers.end(), [&](const Answer& answer) {
    return answer.thickness == thickness;
  });
  if (found == answers.end()) {
    throw InputError(fmt::format("no answer for bars of {} mean rest lengths", thickness));
  }
  return *found;
}

FrameReference loadFrameReference(const std::filesystem::path& file) {
  try {
    const auto json = nlohmann::json::parse(readFile(file));
    FrameReference reference{json.at("title"), flatGrid(json), json.at("poisson"), {}};
    for (const auto& answer : json.at("equilibria")) {
      reference.answers.push_back(answerOf(answer, reference.grid.shape.vertexCount()));
    }
    return reference;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<FrameReference> loadSolids(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with("solid_")) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<FrameReference> solids;
  std::transform(files.begin(), files.end(), std::back_inserter(solids), loadFrameReference);
  return solids;
}

StrutGrid asFrame(StrutGrid grid, double width, double poisson, const JointModel& joint) {
  const BarSection section = rectangularSection({.width = width,
                                                 .height = width,
                                                 .poisson = poisson,
                                                 .joint = joint.radius * width,
                                                 .isShearing = joint.isShearing},
                                                1 / (width * width));
  grid.bars = Bars{section, section, grid.positions};
  return grid;
}

StrutGrid asSpringsForBars(StrutGrid grid, double width) {
  applyMaterial(grid, {.model = Model::bars, .barWidth = width});
  return grid;
}

Mismatch mismatchOf(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others) {
  const Eigen::VectorXd distances =
      (alignRigidly(points, others) * points - others).colwise().norm();
  const double percent = 100 / boundingDiagonal(others);
  return {percent * std::sqrt(distances.squaredNorm() / distances.size()),
          percent * distances.maxCoeff()};
}

double alignedDistance(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others) {
  return mismatchOf(points, others).rms / 100 * boundingDiagonal(others);
}

Eigen::Matrix3Xd twinOf(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  Eigen::Matrix3Xd mirrored(3, positions.cols());
  forEachVertex(shape, [&](const GridPlace& place) {
    mirrored.col(shape.index(place)) =
        positions.col(shape.index(shape.verticesU - 1 - place.i, place.j, place.layer));
  });
  mirrored.row(0) *= -1;
  return mirrored;
}

}  // namespace morphgrid
