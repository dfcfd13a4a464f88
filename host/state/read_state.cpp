#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "report/read_report.h"
#include "state/history_array.h"
#include "state/run_state.h"
#include "state/state_format.h"

namespace morphgrid {
namespace {

constexpr double kRotationTolerance = 1e-6;

/// The grid's shape, from that of the array of printed positions.
GridShape readShape(const ArrayReader& reader) {
  const ArrayShape& shape = reader.file().shapeOf("printed_positions");
  reader.require(shape.size() == 4 && shape[0] >= 1 && shape[1] >= 2 && shape[2] >= 2 &&
                 shape[3] == 3);
  constexpr std::size_t kMostVertices = std::numeric_limits<int>::max() / 3;
  // The file holds as many, so their product does not overflow.
  reader.require(shape[0] * shape[1] * shape[2] <= kMostVertices);
  return {static_cast<int>(shape[2]), static_cast<int>(shape[1]), static_cast<int>(shape[0])};
}

/// One value of each strut, where there is one alone that of all of them.
std::vector<double> strutValues(const ArrayReader& reader, const std::string& name,
                                const ArrayShape& struts) {
  if (reader.file().shapeOf(name) != ArrayShape{1}) {
    return reader.numbers(name, struts, 0);
  }
  const double value = reader.numbers(name, {1}, 0).front();
  return std::vector<double>(struts[0] * struts[1] * struts[2], value);
}

/// The values of struts, each at the index of the vertex that the strut leaves.
std::vector<double> scattered(const ArrayReader& reader, const std::string& name,
                              const GridShape& shape, const ArrayShape& struts) {
  const std::vector<double> gathered = strutValues(reader, name, struts);
  std::vector<double> values(static_cast<std::size_t>(shape.vertexCount()));
  auto from = gathered.begin();
  for (std::size_t k = 0; k < struts[0]; ++k) {
    for (std::size_t j = 0; j < struts[1]; ++j) {
      const auto end = from + static_cast<std::ptrdiff_t>(struts[2]);
      std::copy(from, end,
                values.begin() + shape.index(0, static_cast<int>(j), static_cast<int>(k)));
      from = end;
    }
  }
  return values;
}

StrutValues readStruts(const ArrayReader& reader, const std::string& name, const GridShape& shape) {
  const StateShapes shapes(shape);
  StrutValues values;
  values.u = scattered(reader, name + "_u", shape, shapes.strutsU());
  values.v = scattered(reader, name + "_v", shape, shapes.strutsV());
  values.w = scattered(reader, name + "_w", shape, shapes.strutsW());
  return values;
}

TermWeights readWeights(const ArrayReader& reader) {
  TermWeights weights;
  for (const TermWeight& weight : kTermWeights) {
    const std::string array = weightArray(weight);
    weights.*weight.value =
        weight.before ? reader.number(array, weights.*weight.before) : reader.number(array);
  }
  return weights;
}

StrutGrid readGrid(const ArrayReader& reader, const GridShape& shape) {
  StrutGrid grid{shape,
                 reader.number("spacing"),
                 reader.points("printed_positions", StateShapes(shape).points()),
                 readStruts(reader, "rest", shape),
                 readStruts(reader, "stiffness", shape),
                 readWeights(reader)};
  try {
    validate(grid);
  } catch (const InputError&) {
    reader.require(false);
  }
  return grid;
}

/// A field of one layer from the arrays NAME_u and NAME_v; all values must be above `low`.
LateralField<double> readField(const ArrayReader& reader, const std::string& name,
                               const GridShape& shape, double low) {
  const StateShapes shapes(shape);
  const std::vector<double> u = reader.numbers(name + "_u", shapes.layerStrutsU(), low);
  const std::vector<double> v = reader.numbers(name + "_v", shapes.layerStrutsV(), low);
  LateralField<double> field(shape.verticesU - 1, shape.verticesV - 1);
  auto nextU = u.begin();
  auto nextV = v.begin();
  forEachLateralStrut(field.shape(), [&](const Strut& strut) {
    field.at(strut) = strut.direction == Strut::Direction::u ? *nextU++ : *nextV++;
  });
  return field;
}

/// The design's own rest lengths of all layers: those of the grid where nothing has changed them.
std::vector<LateralField<double>> readDesignedRest(const ArrayReader& reader,
                                                   const GridShape& shape) {
  const StateShapes shapes(shape);
  const std::string name = reader.has("design_rest_u") ? "design_rest" : "rest";
  const std::vector<double> u = strutValues(reader, name + "_u", shapes.strutsU());
  const std::vector<double> v = strutValues(reader, name + "_v", shapes.strutsV());
  auto nextU = u.begin();
  auto nextV = v.begin();
  std::vector<LateralField<double>> rest(shapes.layers, {shape.verticesU - 1, shape.verticesV - 1});
  for (LateralField<double>& layer : rest) {
    forEachLateralStrut(layer.shape(), [&](const Strut& strut) {
      layer.at(strut) = strut.direction == Strut::Direction::u ? *nextU++ : *nextV++;
    });
  }
  return rest;
}

GridDesign readDesign(const ArrayReader& reader, const GridShape& shape) {
  const double angle = -std::numbers::pi - kRotationTolerance;
  GridDesign design{shape.verticesU - 1,
                    shape.verticesV - 1,
                    shape.layers,
                    reader.number("layer_spacing"),
                    reader.number("spacing"),
                    readField(reader, "design_lengths", shape, 0),
                    readField(reader, "design_bend_angles", shape, angle),
                    readDesignedRest(reader, shape),
                    {}};
  reader.require(design.layerSpacing > 0);
  return design;
}

Eigen::Isometry3d readIsometry(const ArrayReader& reader, const std::string& name) {
  const std::vector<double> byRow = reader.numbers(name, {4, 4});
  Eigen::Isometry3d isometry;
  isometry.matrix() = Eigen::Map<const Eigen::Matrix4d>(byRow.data()).transpose();
  const Eigen::Matrix3d rotation = isometry.linear();
  reader.require((rotation.transpose() * rotation).isIdentity(kRotationTolerance) &&
                 isometry.matrix().row(3) == Eigen::RowVector4d(0, 0, 0, 1));
  return isometry;
}

/// None of grids whose joints do not turn, and in files that do not tell.
JointRotations readRotations(const ArrayReader& reader, const GridShape& shape) {
  if (!reader.has("joint_rotations")) {
    return {};
  }
  const std::vector<double> values =
      reader.numbers("joint_rotations", StateShapes(shape).rotations());
  JointRotations rotations =
      Eigen::Map<const JointRotations>(values.data(), 4, shape.vertexCount());
  reader.require(((rotations.colwise().norm().array() - 1).abs() < kRotationTolerance).all());
  return rotations;
}

RunRecord readRecord(const ArrayReader& reader, const GridShape& shape) {
  RunRecord record;
  try {
    record = readReport(reader.file().text("report"));
  } catch (const InputError&) {
    reader.file().refuse();
  }
  const bool isStacked = shape.layers > 1;
  reader.require(record.grid.shape == shape && record.inPlane &&
                 record.full.has_value() == isStacked);
  const StateShapes shapes(shape);
  record.inPlane->positions = reader.points("in_plane_positions", shapes.layerPoints());
  record.inPlane->history = readHistory(reader, "in_plane_history");
  Equilibrium& last = isStacked ? *record.full : *record.inPlane;
  last.positions = reader.points("positions", shapes.points());
  last.rotations = readRotations(reader, shape);
  last.history = readHistory(reader, "history");
  return record;
}

TriangleMesh readMesh(const ArrayReader& reader) {
  const std::size_t triangles = reader.rowCount("mesh_triangles", 3);
  reader.require(triangles >= 1);
  TriangleMesh mesh;
  mesh.vertices = reader.points("mesh_vertices", {reader.rowCount("mesh_vertices", 3), 3});
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles));
  reader.file().copy("mesh_triangles", std::span(mesh.triangles.data(), 3 * triangles));
  reader.require(mesh.triangles.minCoeff() >= 0 &&
                 mesh.triangles.maxCoeff() < mesh.vertices.cols());
  return mesh;
}

RayHits readHits(const ArrayReader& reader) {
  const ArrayShape& shape = reader.file().shapeOf("ray_hits");
  reader.require(shape.size() == 2 && shape[0] >= 2 && shape[1] >= 2 &&
                 shape[0] * shape[1] <= std::numeric_limits<int>::max());
  const std::vector<double> box = reader.numbers("ray_box", {4});
  reader.require(box[2] > 0 && box[3] > 0);
  std::vector<char> hit(shape[0] * shape[1]);
  reader.file().copy("ray_hits",
                     std::span(reinterpret_cast<std::uint8_t*>(hit.data()), hit.size()));
  reader.require(std::ranges::all_of(hit, [](char one) { return one == 0 || one == 1; }));
  return {{box[0], box[1], box[2], box[3]},
          static_cast<int>(shape[1]),
          static_cast<int>(shape[0]),
          reader.points("ray_points", {shape[0], shape[1], 3}),
          std::move(hit)};
}

}  // namespace

RunState readState(const std::filesystem::path& path) {
  const ArrayFile file(path, kStateFormat);
  const ArrayReader reader(file);
  const GridShape shape = readShape(reader);
  RunState state{file.text("program"),
                 file.text("scene"),
                 file.text("scene_file"),
                 readDesign(reader, shape),
                 {},
                 {},
                 readGrid(reader, shape),
                 readIsometry(reader, "target_from_grid"),
                 readRecord(reader, shape)};
  if (reader.has("target_positions")) {
    state.targets = reader.points("target_positions", StateShapes(shape).layerPoints());
  }
  if (reader.has("printed_angle_errors")) {
    const std::vector<double> errors =
        reader.numbers("printed_angle_errors", StateShapes(shape).layerVertices());
    state.angleErrors =
        Eigen::Map<const Eigen::VectorXd>(errors.data(), static_cast<Eigen::Index>(errors.size()));
  }
  if (reader.has("mesh_vertices")) {
    state.sampling = MeshSampling{readMesh(reader), readHits(reader)};
  }
  return state;
}

std::optional<std::filesystem::path> findState(const std::filesystem::path& argument) {
  std::error_code ignored;  // What cannot be looked at is no state; reading it tells why.
  if (std::filesystem::is_directory(argument, ignored)) {
    const std::filesystem::path file = argument / kStateFile;
    if (!std::filesystem::exists(file, ignored)) {
      throw InputError(fmt::format(
          "{}: there is no {} in this folder: morphgrid run leaves one, unless output.state = "
          "false",
          argument.string(), kStateFile));
    }
    return file;
  }
  const bool isState = argument.extension() == std::filesystem::path(kStateFile).extension() ||
                       looksLike(kStateFormat, argument);
  return isState ? std::optional(argument) : std::nullopt;
}

}  // namespace morphgrid
