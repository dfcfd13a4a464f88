#include "app/scene_target.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/read_file.h"
#include "surface/read_patch.h"

namespace morphgrid {
namespace {

constexpr const char* kMeshKeys[] = {"mesh",     "u_start",    "v_start",        "u_length",
                                     "v_length", "fill_holes", "steepest_slope", "smoothing_width"};
constexpr const char* kBoxKeys[] = {"u_start", "v_start", "u_length", "v_length"};

enum class SurfaceKind { bezier, mesh, bendAngles };

constexpr const char* kindName(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::bezier:
      return "bezier";
    case SurfaceKind::mesh:
      return "mesh";
    case SurfaceKind::bendAngles:
      break;
  }
  return "bend_angles";
}

std::vector<const char*> namesOf(const std::vector<SurfaceKind>& kinds) {
  std::vector<const char*> names;
  for (const SurfaceKind kind : kinds) names.push_back(kindName(kind));
  return names;
}

std::optional<SurfaceKind> readKind(TomlSection& surface) {
  const auto kind = surface.choice<SurfaceKind>(
      "kind", {{kindName(SurfaceKind::bezier), SurfaceKind::bezier},
               {kindName(SurfaceKind::mesh), SurfaceKind::mesh},
               {kindName(SurfaceKind::bendAngles), SurfaceKind::bendAngles}});
  surface.require("kind");
  return kind;
}

void rejectKeysOfOtherKinds(SurfaceKind kind, TomlSection& surface, TomlSection& grid,
                            TomlSection& design) {
  struct KindKeys {
    std::vector<SurfaceKind> kinds;
    TomlSection& section;
    std::vector<const char*> keys;
  };
  using enum SurfaceKind;
  const KindKeys all[] = {
      {{bezier}, surface, {"patch"}},
      {{mesh}, surface, {std::begin(kMeshKeys), std::end(kMeshKeys)}},
      {{bendAngles}, surface, {"theta_u", "theta_v", "spacing"}},
      {{bezier, mesh}, grid, {"nodes_long", "curvature_cutoff"}},
      {{bendAngles}, grid, {"nodes_u", "nodes_v"}},
      {{bezier, mesh},
       design,
       {"net", "reference", "max_strut_ratio", "compensate", "optimise", "enforce_shrinkage"}},
  };
  for (const auto& [kinds, section, keys] : all) {
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
    for (const char* key : keys) {
      section.reject(key, fmt::format("belongs to surfaces of kind \"{}\", this one is \"{}\"",
                                      fmt::join(namesOf(kinds), "\" or \""), kindName(kind)));
    }
  }
}

using File = std::optional<std::filesystem::path>;

/// Whether the file that a key names, if it does, can be read; a problem otherwise.
bool isReadable(TomlReader& reader, const TomlSection& surface, const char* key, const char* what,
                const File& file) {
  if (!file) return false;
  const auto reason = whyUnreadable(*file);
  if (reason) {
    reader.problems.add(surface.place(key),
                        fmt::format("{} must name a readable {}, got {}: {}", surface.fullName(key),
                                    what, file->string(), *reason));
  }
  return !reason;
}

PatchRequest readPatchRequest(TomlReader& reader, TomlSection& surface, const File& file) {
  PatchRequest request{{}, surface.place("patch")};
  surface.require("patch");
  if (isReadable(reader, surface, "patch", "file", file)) {
    try {
      request.controlPoints = readPatch(*file).controlPoints();
    } catch (const InputError& error) {
      reader.problems.add(error);
    }
  }
  return request;
}

/// Nothing when no key of the box is there: that is for the target to say, who knows the mesh.
std::optional<SamplingBox> readBox(TomlSection& surface) {
  const SamplingBox box{surface.number("u_start", {}).value_or(0),
                        surface.number("v_start", {}).value_or(0),
                        surface.number("u_length", above(0)).value_or(1),
                        surface.number("v_length", above(0)).value_or(1)};
  if (std::none_of(std::begin(kBoxKeys), std::end(kBoxKeys),
                   [&](const char* key) { return surface.node(key) != nullptr; })) {
    return std::nullopt;
  }
  return box;
}

MeshRequest readMeshRequest(TomlSection& surface) {
  MeshRequest request;
  request.box = readBox(surface);
  request.boxPlace = surface.place("u_start");
  request.fillHoles = surface.number("fill_holes", atLeast(0)).value_or(request.fillHoles);
  request.steepestSlope =
      surface.number("steepest_slope", above(0)).value_or(request.steepestSlope);
  request.smoothingWidth =
      surface.number("smoothing_width", atLeast(0)).value_or(request.smoothingWidth);
  return request;
}

/// What a mesh needs.
void completeMeshRequest(TomlReader& reader, TomlSection& surface, const File& file,
                         MeshRequest& request) {
  surface.require("mesh");
  if (request.box) {
    for (const char* key : kBoxKeys) surface.require(key);
  }
  if (isReadable(reader, surface, "mesh", "mesh configuration", file)) {
    try {
      request.configuration = readMeshConfiguration(*file);
    } catch (const InputError& error) {
      reader.problems.add(error);
    }
  }
}

DesignRequest readDesign(TomlSection& grid, TomlSection& section) {
  const IntegerRange count{1, std::numeric_limits<int>::max()};
  DesignRequest design;
  design.layers = static_cast<int>(grid.integer("layers", {1, 64}).value_or(design.layers));
  design.layerSpacing = grid.number("layer_spacing", above(0)).value_or(design.layerSpacing);
  grid.require("layer_spacing");
  design.nodesLong = static_cast<int>(grid.integer("nodes_long", count).value_or(design.nodesLong));
  design.maxShrinkage = grid.number("max_shrinkage", between(0, 1)).value_or(design.maxShrinkage);
  design.curvatureCutoff =
      grid.number("curvature_cutoff", aboveUpTo(0, 1)).value_or(design.curvatureCutoff);
  design.strutThickness = grid.number("strut_thickness", above(0));
  design.net = section
                   .choice<NetKind>("net", {{nameOf(NetKind::isoline), NetKind::isoline},
                                            {nameOf(NetKind::orthogonal), NetKind::orthogonal}})
                   .value_or(design.net);
  design.reference =
      section
          .choice<Reference>("reference",
                             {{"convex", Reference::convex}, {"middle", Reference::middle}})
          .value_or(design.net == NetKind::isoline ? Reference::convex : Reference::middle);
  design.maxStrutRatio = section.number("max_strut_ratio", above(1));
  constexpr IntegerRange kRounds{0, 10000};
  design.compensateRounds =
      static_cast<int>(section.integer("compensate", kRounds).value_or(design.compensateRounds));
  design.optimiseSteps =
      static_cast<int>(section.integer("optimise", kRounds).value_or(design.optimiseSteps));
  design.enforceShrinkage = section.boolean("enforce_shrinkage").value_or(design.enforceShrinkage);
  return design;
}

BendAngleRequest readBendAngles(TomlSection& surface, TomlSection& grid) {
  constexpr double pi = std::numbers::pi;
  constexpr std::array<double, 2> kFlat{0, 0};
  const IntegerRange count{1, std::numeric_limits<int>::max()};
  const auto [firstThetaU, lastThetaU] =
      surface.numberPair("theta_u", fromTo(-pi, pi)).value_or(kFlat);
  const auto [firstThetaV, lastThetaV] =
      surface.numberPair("theta_v", fromTo(-pi, pi)).value_or(kFlat);
  return {.nodesU = static_cast<int>(grid.integer("nodes_u", count).value_or(1)),
          .nodesV = static_cast<int>(grid.integer("nodes_v", count).value_or(1)),
          .spacing = surface.number("spacing", above(0)).value_or(1),
          .firstThetaU = firstThetaU,
          .lastThetaU = lastThetaU,
          .firstThetaV = firstThetaV,
          .lastThetaV = lastThetaV};
}

/// Struts, about three a vertex, are counted in int. In double, which the largest counts do not
/// overflow.
void checkVertexCount(TomlReader& reader, const TomlSection& grid, std::string_view key,
                      double nodesU, double nodesV, int layers) {
  constexpr int kLimit = std::numeric_limits<int>::max() / 3;
  const double count = (nodesU + 1) * (nodesV + 1) * layers;
  if (count <= kLimit) return;
  reader.problems.add(
      grid.place(key),
      fmt::format("{} asks for too large a grid: at most {} vertices are possible, got {:.4g}",
                  grid.fullName(key), kLimit, count));
}

}  // namespace

SceneTarget readSceneTarget(TomlReader& reader) {
  TomlSection surface = reader.section("surface");
  TomlSection grid = reader.section("grid");
  TomlSection designSection = reader.section("design");
  const std::optional<SurfaceKind> kind = readKind(surface);
  if (kind) rejectKeysOfOtherKinds(*kind, surface, grid, designSection);

  // All keys are read whatever the kind is: that finds every problem, and all names are known.
  const File patchFile = surface.path("patch");
  const File meshFile = surface.path("mesh");
  MeshRequest mesh = readMeshRequest(surface);
  const DesignRequest design = readDesign(grid, designSection);
  const BendAngleRequest bendAngles = readBendAngles(surface, grid);

  SceneTarget target{.surface = bendAngles, .design = design};
  if (kind == SurfaceKind::bezier) {
    target.surface = readPatchRequest(reader, surface, patchFile);
  } else if (kind == SurfaceKind::mesh) {
    completeMeshRequest(reader, surface, meshFile, mesh);
    target.surface = std::move(mesh);
  } else if (kind == SurfaceKind::bendAngles) {
    grid.require("nodes_u");
    grid.require("nodes_v");
    const char* key = bendAngles.nodesU >= bendAngles.nodesV ? "nodes_u" : "nodes_v";
    checkVertexCount(reader, grid, key, bendAngles.nodesU, bendAngles.nodesV, design.layers);
  }
  if (kind == SurfaceKind::bezier || kind == SurfaceKind::mesh) {
    // The shorter direction is not known before the surface is measured: it has at least one node.
    checkVertexCount(reader, grid, "nodes_long", design.nodesLong, 1, design.layers);
  }
  return target;
}

}  // namespace morphgrid
