#include "surface/read_patch.h"

#include <fmt/format.h>

#include "core/toml_reader.h"

namespace morphgrid {
namespace {

BezierPatch::ControlPoints readControlPoints(TomlReader& reader) {
  BezierPatch::ControlPoints points{};
  TomlSection root = reader.root();
  const toml::array* rows = root.array("control_points", 4, "an array of 4 rows (along v)");
  root.require("control_points");
  for (int j = 0; rows && j < 4; ++j) {
    const std::string rowName = fmt::format("control_points[{}]", j);
    const toml::array* row = reader.array(rowName, *rows->get(j), 4, "a row of 4 points (along u)");
    for (int i = 0; row && i < 4; ++i) {
      points[j][i] = reader
                         .vector(fmt::format("{}[{}]", rowName, i), *row->get(i), NumberRange(),
                                 "a point of 3 numbers, [x, y, z]")
                         .value_or(Eigen::Vector3d::Zero());
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
