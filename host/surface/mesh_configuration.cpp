#include "surface/mesh_configuration.h"

#include <fmt/format.h>

#include <numbers>
#include <tuple>

#include "core/read_file.h"
#include "core/toml_reader.h"

namespace morphgrid {
namespace {

constexpr IntegerRange kSampleCounts{4, 4096};
constexpr IntegerRange kSubdivisions{0, 10};
constexpr const char* kVector = "3 numbers, [x, y, z]";

std::filesystem::path readMeshPath(TomlReader& reader, const std::filesystem::path& folder) {
  TomlSection root = reader.root();
  const auto name = root.text("mesh");
  root.require("mesh");
  if (!name) return {};
  std::filesystem::path mesh = folder / *name;
  if (const auto reason = whyUnreadable(mesh)) {
    const bool missing = !std::filesystem::exists(mesh);
    reader.problems.add(
        root.place("mesh"),
        fmt::format("mesh must name a readable file, got {}: {}{}", mesh.string(), *reason,
                    missing ? " (tools/run installs and makes the meshes of scenes/)" : ""));
  }
  return mesh;
}

/// These return the identity for what is missing or a problem.
Eigen::Matrix3d readRotation(TomlReader& reader, TomlSection rotate) {
  if (!rotate.present()) return Eigen::Matrix3d::Identity();
  const auto axis = rotate.vector("axis", NumberRange(), kVector);
  const auto degrees = rotate.number("degrees", NumberRange());
  rotate.require("axis");
  rotate.require("degrees");
  if (axis && axis->isZero(0)) {
    reader.problems.add(rotate.place("axis"),
                        rotate.fullName("axis") + " must have a direction, got [0, 0, 0]");
  }
  if (!axis || !degrees) return Eigen::Matrix3d::Identity();
  const double angle = *degrees * std::numbers::pi / 180;
  return Eigen::AngleAxisd(angle, axis->stableNormalized()).toRotationMatrix();
}

Eigen::Vector3d readScale(TomlSection& entry) {
  const toml::node* scale = entry.node("scale");
  if (scale && scale->is_array()) {
    return entry.vector("scale", above(0), "a number > 0 or 3 of them, [x, y, z]")
        .value_or(Eigen::Vector3d::Ones());
  }
  return Eigen::Vector3d::Constant(entry.number("scale", above(0)).value_or(1));
}

Eigen::Affine3d readTransform(TomlReader& reader, const std::string& name, const toml::node& node) {
  TomlSection entry = reader.table(name, node);
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = readRotation(reader, entry.table("rotate", "a table of axis and degrees"));
  transform.scale(readScale(entry));
  transform.translation() =
      entry.vector("translate", NumberRange(), kVector).value_or(Eigen::Vector3d::Zero());

  int keys = 0;
  for (const char* key : {"rotate", "scale", "translate"}) keys += entry.node(key) ? 1 : 0;
  if (entry.present() && keys != 1) {
    reader.problems.add(
        reader.place(node),
        fmt::format("{} must hold one of rotate, scale and translate, got {}", name, keys));
  }
  return transform;
}

Eigen::Affine3d readTransforms(TomlReader& reader) {
  TomlSection root = reader.root();
  const toml::array* steps =
      root.array("transforms", "an array of tables, each of rotate, scale or translate");
  Eigen::Affine3d worldFromMesh = Eigen::Affine3d::Identity();
  for (std::size_t n = 0; steps && n < steps->size(); ++n) {
    const std::string name = fmt::format("transforms[{}]", n);
    worldFromMesh = readTransform(reader, name, *steps->get(n)) * worldFromMesh;
  }
  if (!worldFromMesh.matrix().allFinite() || worldFromMesh.linear().determinant() == 0) {
    reader.problems.add(root.place("transforms"),
                        "transforms must neither overflow nor flatten the mesh, taken together");
  }
  return worldFromMesh;
}

}  // namespace

bool MeshConfiguration::operator==(const MeshConfiguration& other) const {
  const auto tied = [](const MeshConfiguration& configuration) {
    const auto& [file, world, countU, countV, rounds] = configuration;
    return std::tuple(file, Eigen::Matrix4d(world.matrix()), countU, countV, rounds);
  };
  return tied(*this) == tied(other);
}

MeshConfiguration readMeshConfiguration(const std::filesystem::path& file) {
  TomlReader reader(file, parseToml(file));
  TomlSection root = reader.root();
  const auto integer = [&](const char* key, const IntegerRange& range, int otherwise) {
    return static_cast<int>(root.integer(key, range).value_or(otherwise));
  };
  MeshConfiguration mesh{.mesh = readMeshPath(reader, file.parent_path()),
                         .worldFromMesh = readTransforms(reader)};
  mesh.samplesU = integer("samples_u", kSampleCounts, mesh.samplesU);
  mesh.samplesV = integer("samples_v", kSampleCounts, mesh.samplesV);
  mesh.subdivisions = integer("subdivisions", kSubdivisions, mesh.subdivisions);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  return mesh;
}

}  // namespace morphgrid
