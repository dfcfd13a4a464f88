#include "surface/read_patch.h"

#include <fmt/format.h>

#include "core/read_toml_key.h"
#include "surface/patch_keys.h"

namespace morphgrid {
namespace {

using ControlPoints = BezierPatch::ControlPoints;

constexpr const char* kControlPoints = "control_points";

void readControlPoints(TomlReader& reader, ControlPoints& points) {
  const toml::array* rows = reader.root().array(kControlPoints, 4, "an array of 4 rows (along v)");
  for (int j = 0; rows && j < 4; ++j) {
    const std::string rowName = fmt::format("{}[{}]", kControlPoints, j);
    const toml::array* row = reader.array(rowName, *rows->get(j), 4, "a row of 4 points (along u)");
    for (int i = 0; row && i < 4; ++i) {
      points[j][i] = reader
                         .vector(fmt::format("{}[{}]", rowName, i), *row->get(i), NumberRange(),
                                 "a point of 3 numbers, [x, y, z]")
                         .value_or(Eigen::Vector3d::Zero());
    }
  }
}

}  // namespace

const std::vector<TomlKey<ControlPoints>>& patchKeys() {
  static const std::vector<TomlKey<ControlPoints>> kKeys = {
      {.name = kControlPoints,
       .value = CustomKey<ControlPoints>{readControlPoints, "array of arrays",
                                         "4 rows of 4 points of 3 numbers"},
       .unit = "length",
       .isRequired = true,
       .meaning = "The control points [x, y, z] of a bicubic patch, row by row: rows follow each "
                  "other along v, the points of a row along u. They must span an area."},
  };
  return kKeys;
}

BezierPatch readPatch(const std::filesystem::path& file) {
  TomlReader reader(file, parseToml(file));
  const auto points = readTopLevel(reader, patchKeys());
  try {
    return BezierPatch(points);
  } catch (const InputError& error) {
    const Place place = reader.root().place(kControlPoints);
    throw InputError(fmt::format("{}: {}: {}", toString(place), kControlPoints, error.what()));
  }
}

}  // namespace morphgrid
