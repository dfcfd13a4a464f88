#include "surface/mesh_configuration_keys.h"

#include <fmt/format.h>

#include <numbers>

#include "core/key_place.h"
#include "core/read_toml_key.h"
#include "surface/load_mesh.h"

namespace morphgrid {
namespace {

constexpr IntegerRange kSampleCounts{4, 4096};
constexpr IntegerRange kSubdivisions{0, 10};
constexpr const char* kVector = "3 numbers, [x, y, z]";

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

void readTransforms(TomlReader& reader, MeshConfiguration& configuration) {
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
  configuration.worldFromMesh = worldFromMesh;
}

}  // namespace

const std::vector<TomlKey<MeshConfiguration>>& meshConfigurationKeys() {
  using Mesh = MeshConfiguration;
  static const std::vector<TomlKey<Mesh>> kKeys = {
      {.name = "mesh",
       .value = fileKey(at(&Mesh::mesh), "file", "(if it belongs to scenes/, tools/run makes it)"),
       .isRequired = true,
       .meaning = "The mesh: OBJ, STL, PLY, glTF or GLB, relative to this file."},
      {.name = "samples_u",
       .value = integerKey(at(&Mesh::samplesU), kSampleCounts),
       .meaning = "Rays along u in the first pass, which measures extents and curvature."},
      {.name = "samples_v",
       .value = integerKey(at(&Mesh::samplesV), kSampleCounts),
       .meaning = "Rays along v."},
      {.name = "subdivisions",
       .value = integerKey(at(&Mesh::subdivisions), kSubdivisions),
       .meaning = "Rounds of Loop subdivision before the rays, for coarse meshes."},
      {.name = "transforms",
       .value = CustomKey<Mesh>{readTransforms, "array of tables",
                                "one of `rotate`, `scale`, `translate` each"},
       .meaning = "Moves the mesh, in this order. `rotate` is a table of `axis` (3 numbers) and "
                  "`degrees`; `scale` a number > 0 or 3 of them; `translate` 3 numbers."},
  };
  return kKeys;
}

bool MeshConfiguration::operator==(const MeshConfiguration& other) const {
  const auto& [file, world, countU, countV, rounds] = *this;  // All members: another must be here.
  return file == other.mesh && world.matrix() == other.worldFromMesh.matrix() &&
         countU == other.samplesU && countV == other.samplesV && rounds == other.subdivisions;
}

MeshConfiguration readMeshConfiguration(const std::filesystem::path& file) {
  if (isMeshName(file)) return {.mesh = file};
  TomlReader reader(file, parseToml(file));
  return readTopLevel(reader, meshConfigurationKeys());
}

}  // namespace morphgrid
