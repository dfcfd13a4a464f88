#include "surface/read_patch.h"

#include <fmt/format.h>

#include "core/toml_reader.h"

namespace morphgrid {
namespace {

Eigen::Vector3d readPoint(TomlReader& reader, const std::string& name, const toml::node& node) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  const toml::array* numbers = reader.array(name, node, 3, "a point of 3 numbers, [x, y, z]");
  for (int axis = 0; numbers && axis < 3; ++axis) {
    const std::string element = fmt::format("{}[{}]", name, axis);
    point[axis] = reader.number(element, *numbers->get(axis), NumberRange()).value_or(0);
  }
  return point;
}

BezierPatch::ControlPoints readControlPoints(TomlReader& reader) {
  BezierPatch::ControlPoints points{};
  TomlSection root = reader.root();
  const toml::array* rows = root.array("control_points", 4, "an array of 4 rows (along v)");
  root.require("control_points");
  for (int j = 0; rows && j < 4; ++j) {
    const std::string rowName = fmt::format("control_points[{}]", j);
    const toml::array* row = reader.array(rowName, *rows->get(j), 4, "a row of 4 points (along u)");
    for (int i = 0; row && i < 4; ++i) {
      points[j][i] = readPoint(reader, fmt::format("{}[{}]", rowName, i), *row->get(i));
    }
  }
  return points;
}

}  // namespace

BezierPatch readPatch(const std::filesystem::path& file) {
  TomlReader reader(file, parseToml(file));
  const BezierPatch::ControlPoints points = readControlPoints(reader);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  try {
    return BezierPatch(points);
  } catch (const InputError& error) {
    const Place place = reader.root().place("control_points");
    throw InputError(fmt::format("{}: control_points: {}", toString(place), error.what()));
  }
}

}  // namespace morphgrid
