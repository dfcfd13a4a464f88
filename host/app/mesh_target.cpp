#include "app/mesh_target.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/mesh_sampler.h"
#include "core/read_file.h"
#include "surface/load_mesh.h"
#include "surface/mesh_configuration.h"
#include "surface/subdivide_mesh.h"

namespace morphgrid {
namespace {

constexpr const char* kBoxKeys[] = {"u_start", "v_start", "u_length", "v_length"};

void requireBox(TomlReader& reader, TomlSection& surface, const MeshTarget& target) {
  if (std::any_of(std::begin(kBoxKeys), std::end(kBoxKeys),
                  [&](const char* key) { return surface.node(key) != nullptr; })) {
    for (const char* key : kBoxKeys) surface.require(key);
    return;
  }
  reader.problems.add(
      surface.place("u_start"),
      fmt::format("surface.u_start, v_start, u_length and v_length are missing: the box that rays "
                  "sample; {}",
                  MeshSampler(target).boxAdvice()));
}

TriangleMesh subdivided(const MeshConfiguration& configuration) {
  const TriangleMesh mesh = loadMesh(configuration.mesh);
  try {
    return subdivideLoop(mesh, configuration.subdivisions);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", configuration.mesh.string(), error.what()));
  }
}

/// What the configuration file asks for, loaded.
MeshTarget loadConfigured(const std::filesystem::path& file, MeshTarget target) {
  const MeshConfiguration configuration = readMeshConfiguration(file);
  target.file = configuration.mesh;
  target.samplesU = configuration.samplesU;
  target.samplesV = configuration.samplesV;
  target.mesh = transformed(configuration.worldFromMesh, subdivided(configuration));
  return target;
}

}  // namespace

MeshKeys readMeshKeys(TomlSection& surface) {
  MeshKeys keys;
  keys.mesh = surface.path("mesh");
  keys.uStart = surface.number("u_start", {});
  keys.vStart = surface.number("v_start", {});
  keys.uLength = surface.number("u_length", above(0));
  keys.vLength = surface.number("v_length", above(0));
  MeshTarget& settings = keys.settings;
  settings.fillHoles = surface.number("fill_holes", atLeast(0)).value_or(settings.fillHoles);
  settings.steepestSlope =
      surface.number("steepest_slope", above(0)).value_or(settings.steepestSlope);
  settings.smoothingWidth =
      surface.number("smoothing_width", atLeast(0)).value_or(settings.smoothingWidth);
  return keys;
}

std::shared_ptr<const MeshTarget> loadMeshTarget(TomlReader& reader, TomlSection& surface,
                                                 MeshKeys keys) {
  surface.require("mesh");
  if (!keys.mesh) return nullptr;
  if (const auto reason = whyUnreadable(*keys.mesh)) {
    reader.problems.add(
        surface.place("mesh"),
        fmt::format("surface.mesh must name a readable mesh configuration, got {}: {}",
                    keys.mesh->string(), *reason));
    return nullptr;
  }
  try {
    MeshTarget target = loadConfigured(*keys.mesh, std::move(keys.settings));
    requireBox(reader, surface, target);
    target.box = {keys.uStart.value_or(0), keys.vStart.value_or(0), keys.uLength.value_or(1),
                  keys.vLength.value_or(1)};
    return std::make_shared<MeshTarget>(std::move(target));
  } catch (const InputError& error) {
    reader.problems.add(error);
    return nullptr;
  }
}

}  // namespace morphgrid
