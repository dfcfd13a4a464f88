#include "app/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "app/scene_keys.h"
#include "app/scene_text.h"
#include "core/error.h"
#include "core/read_toml_key.h"
#include "core/visible_text.h"
#include "surface/read_patch.h"

namespace morphgrid {
namespace {

constexpr const char* kBoxKeys[] = {"u_start", "v_start", "u_length", "v_length"};

/// Reads a scene, key by key, and what belongs to several keys at once.
class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, const std::string& name, toml::table document)
      : reader_(file, std::move(document)), scene_{.name = name, .file = file} {}

  Scene read() {
    for (const SceneKeySection& keys : sceneKeys()) {
      readSection(keys);
    }
    if (kind_) {
      rejectKeysOfOthersOnTop();
      TomlSection surface = reader_.section("surface");
      std::visit([&](auto& request) { complete(surface, request); }, scene_.surface);
      checkSize();
    }
    checkWeight();
    completePrint();
    reader_.reportUnknownKeys();
    reader_.problems.throwIfAny();
    scene_.text = sceneText(reader_);
    return std::move(scene_);
  }

 private:
  /// All keys are read where the kind is not known: that finds every problem.
  void readSection(const SceneKeySection& keys) {
    TomlSection section = keys.name.empty() ? reader_.root() : reader_.section(keys.name);
    TomlKeyReader<Scene> values(reader_, section, scene_);
    for (const SceneKey& key : keys.keys) {
      if (kind_ && !key.isOf(*kind_)) {
        reject(section, key);
        continue;
      }
      const bool isRead = values.read(key);
      if (key.isRequired && (kind_ || key.kinds.empty())) {
        section.require(key.name);
      }
      if (keys.name == "surface" && key.name == "kind" && isRead) {
        kind_ = scene_.surface.index();
      }
    }
  }

  void reject(TomlSection& section, const SceneKey& key) const {
    std::vector<const char*> owners;
    for (const std::size_t kind : key.kinds) owners.push_back(kSurfaceWords[kind]);
    section.reject(key.name, fmt::format("belongs to surfaces of kind \"{}\", this one is \"{}\"",
                                         fmt::join(owners, "\" or \""), kSurfaceWords[*kind_]));
  }

  /// The top level is read before the kind is known.
  void rejectKeysOfOthersOnTop() {
    TomlSection root = reader_.root();
    for (const SceneKey& key : sceneKeys().front().keys) {
      if (!key.isOf(*kind_)) reject(root, key);
    }
  }

  /// The TOML files that a surface names.
  template <typename Read>
  void readFile(const std::filesystem::path& file, const Read& read) {
    try {
      if (!file.empty()) read();
    } catch (const InputError& error) {
      reader_.problems.add(error);
    }
  }

  void complete(TomlSection& surface, PatchRequest& request) {
    request.place = surface.place("patch");
    readFile(request.file,
             [&] { request.controlPoints = readPatch(request.file).controlPoints(); });
  }

  void complete(TomlSection& surface, MeshRequest& request) {
    request.boxPlace = surface.place("u_start");
    if (std::any_of(std::begin(kBoxKeys), std::end(kBoxKeys),
                    [&](const char* key) { return surface.node(key) != nullptr; })) {
      for (const char* key : kBoxKeys) surface.require(key);
    }
    readFile(request.file, [&] { request.configuration = readMeshConfiguration(request.file); });
  }

  void complete(TomlSection&, BendAngleRequest&) {}

  void completePrint() {
    TomlSection section = reader_.section("print");
    if (!section.present()) return;
    section.require("printer");
    section.require("material");
    if (!scene_.print) return;
    ScenePrint& print = *scene_.print;
    readFile(print.printerFile, [&] { print.tools.printer = readPrinter(print.printerFile); });
    readFile(print.materialFile, [&] {
      print.tools.material = readPrintMaterial(print.materialFile);
      if (!reader_.section("grid").node("max_shrinkage")) {
        scene_.design.maxShrinkage = -print.tools.material.along.change;
      }
    });
  }

  void checkSize() {
    const DesignRequest& design = scene_.design;
    if (const auto* bent = std::get_if<BendAngleRequest>(&scene_.surface)) {
      checkVertexCount(bent->nodesU >= bent->nodesV ? "nodes_u" : "nodes_v", bent->nodesU,
                       bent->nodesV);
    } else {
      // The shorter direction is not known before the surface is measured: it has at least one
      // node.
      checkVertexCount("nodes_long", design.nodesLong, 1);
    }
  }

  /// Struts, about three a vertex, are counted in int. In double, which the largest counts do not
  /// overflow.
  void checkVertexCount(const char* key, double nodesU, double nodesV) {
    constexpr int kLimit = std::numeric_limits<int>::max() / 3;
    const double count = (nodesU + 1) * (nodesV + 1) * scene_.design.layers;
    if (count <= kLimit) return;
    const TomlSection grid = reader_.section("grid");
    reader_.problems.add(
        grid.place(key),
        fmt::format("{} asks for too large a grid: at most {} vertices are possible, got {:.4g}",
                    grid.fullName(key), kLimit, count));
  }

  void checkWeight() {
    TomlSection section = reader_.section("material");
    const MaterialRequest& material = scene_.material;
    const auto report = [&](const char* key, const char* what) {
      reader_.problems.add(section.place(key),
                           fmt::format("{} needs {}", section.fullName(key), what));
    };
    if (material.model != Model::frame) {
      constexpr const char* kNeedsFrame =
          "material.model = \"frame\": springs neither weigh nor are they held; set it or leave "
          "the key out";
      if (material.gravity) report("gravity", kNeedsFrame);
      if (!material.supports.empty()) report("supports", kNeedsFrame);
      return;
    }
    if (material.slide && material.supports.empty()) {
      report("slide", "material.supports that slide");
    }
    if (material.gravity) {
      if (material.slide && ((*material.gravity)[0] != 0 || (*material.gravity)[1] != 0)) {
        report("slide", "material.gravity along z: else the grid slides away");
      }
      if (!material.density) report("gravity", "material.density, in kg/m^3");
      if (!material.modulus) report("gravity", "material.modulus, in Pa");
      if (material.supports.empty()) {
        report(
            "gravity",
            "material.supports: a grid that nothing holds falls freely, and weight does not bend "
            "it");
      }
    }
  }

  TomlReader reader_;
  Scene scene_;
  std::optional<std::size_t> kind_;
};

/// Inverse design simulates, step by step.
void requireWhatInverseDesignNeeds(const Scene& scene) {
  const DesignRequest& design = scene.design;
  if (design.compensateRounds + design.optimiseSteps == 0 && !design.enforceShrinkage) {
    return;
  }
  const char* keys = "design.compensate, design.optimise and design.enforce_shrinkage";
  if (scene.method != Method::multigrid) {
    throw InputError(
        fmt::format("{}: {} need solver.method = \"multigrid\"", scene.file.string(), keys));
  }
  if (scene.design.layers == 1) {
    throw InputError(fmt::format("{}: {} need grid.layers >= 2, got 1", scene.file.string(), keys));
  }
}

void requireShrinkRange(const Scene& scene) {
  const double least = scene.material.leastShrinkage;
  const double most = scene.design.maxShrinkage;
  if (least >= most) {
    throw InputError(fmt::format(
        "{}: material.least_shrinkage must be less than grid.max_shrinkage = {:g}, got {:g}",
        scene.file.string(), most, least));
  }
}

void requireWhatFramesNeed(const Scene& scene) {
  if (scene.material.model != Model::frame) {
    return;
  }
  const auto require = [&](bool holds, const char* what) {
    if (!holds) {
      throw InputError(fmt::format("{}: material.model = \"frame\" {}", scene.file.string(), what));
    }
  };
  const DesignRequest& design = scene.design;
  require(design.layers > 1, "needs grid.layers >= 2, got 1");
  require(scene.method != Method::jacobi,
          "needs solver.method = \"multigrid\" or \"reference\", got \"jacobi\"");
  require(!scene.smallestEigenvalue || scene.method == Method::multigrid,
          "with solver.smallest_eigenvalue needs solver.method = \"multigrid\"");
}

Scene readChecked(const std::filesystem::path& file, const std::string& name,
                  toml::table document) {
  Scene scene = SceneReader(file, name, std::move(document)).read();
  scene.title = visibleText(scene.title);
  requireWhatInverseDesignNeeds(scene);
  requireWhatFramesNeed(scene);
  requireShrinkRange(scene);
  return scene;
}

}  // namespace

Scene loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return readChecked(file, file.stem().string(), parseToml(file, overrides));
}

Scene loadSceneText(const std::string& text, const std::filesystem::path& file,
                    const std::string& name, const std::vector<std::string>& overrides) {
  return readChecked(file, name, parseTomlText(text, file, overrides));
}

std::vector<std::string> knownSceneKeys() {
  std::vector<std::string> names;
  for (const SceneKeySection& section : sceneKeys()) {
    for (const SceneKey& key : section.keys) {
      names.push_back(section.name.empty() ? key.name : section.name + "." + key.name);
    }
  }
  return names;
}

}  // namespace morphgrid
