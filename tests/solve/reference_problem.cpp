#include "tests/solve/reference_problem.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/rigid_alignment.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

Eigen::Matrix3Xd toPositions(const nlohmann::json& list) {
  const auto values = list.get<std::vector<double>>();
  return Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3,
                                            static_cast<Eigen::Index>(values.size() / 3));
}

}  // namespace

ReferenceProblem loadReferenceProblem(const std::string& name) {
  std::ifstream stream(sourceFolder() / "tests/reference" / (name + ".json"));
  const auto json = nlohmann::json::parse(stream);
  ReferenceProblem problem;
  StrutGrid& grid = problem.grid;
  grid.shape = {json["vertices_u"], json["vertices_v"], json["layers"]};
  grid.positions = toPositions(json["initial_positions"]);
  grid.rest.u = json["rest_u"].get<std::vector<double>>();
  grid.rest.v = json["rest_v"].get<std::vector<double>>();
  grid.rest.w = json["rest_w"].get<std::vector<double>>();
  grid.stiffness = StrutValues(grid.shape);
  grid.weights = TermWeights::ofAllCorners(json["weight_angle"]);
  grid.spacing = 0;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const bool vertical = strut.direction == Strut::Direction::w;
    const double weight = json[vertical ? "weight_vertical" : "weight_lateral"];
    const double rest = valueAt(grid.rest, strut);
    const double length = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
    valueAt(grid.stiffness, strut) = weight * length / (rest * rest);
    if (!vertical) {
      grid.spacing = std::max(grid.spacing, length);
    }
  });
  problem.shapeopPositions = toPositions(json["final_positions"]);
  problem.shapeopEnergy = json["energy"].back();
  problem.minimumEnergy = json["minimum_energy"];
  return problem;
}

double largestAlignedDistance(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  const Eigen::Matrix3Xd aligned = alignRigidly(from, to) * from;
  return (aligned - to).colwise().norm().maxCoeff();
}

}  // namespace morphgrid
