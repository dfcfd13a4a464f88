#include "app/scene.h"

#include <fmt/format.h>

#include "app/scene_settings.h"
#include "app/scene_target.h"
#include "app/scene_text.h"
#include "core/error.h"
#include "core/toml_reader.h"

namespace morphgrid {
namespace {

Scene readScene(TomlReader& reader, const std::filesystem::path& file) {
  Scene scene{.name = file.stem().string(), .file = file};
  reader.root().text("extends");  // parseToml() has followed it.
  scene.title = reader.root().text("title").value_or(scene.name);
  SceneTarget target = readSceneTarget(reader);
  scene.surface = std::move(target.surface);
  scene.design = target.design;
  scene.weights = readWeights(reader);
  SolverSettings solver = readSolverSettings(reader);
  scene.method = solver.method;
  scene.scaling = solver.scaling;
  scene.solve = std::move(solver.options);
  scene.smallestEigenvalue = solver.smallestEigenvalue;
  const OutputChoices output = readOutputChoices(reader);
  scene.pictures = output.pictures;
  scene.files = output.files;
  scene.published = readPublishedFigures(reader);
  reader.reportUnknownKeys();
  return scene;
}

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

Scene readChecked(const std::filesystem::path& file, toml::table&& document) {
  TomlReader reader(file, std::move(document));
  Scene scene = readScene(reader, file);
  reader.problems.throwIfAny();
  requireWhatInverseDesignNeeds(scene);
  scene.text = sceneText(reader);
  return scene;
}

}  // namespace

Scene loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return readChecked(file, parseToml(file, overrides));
}

Scene loadSceneText(const std::string& text, const std::filesystem::path& file) {
  return readChecked(file, parseTomlText(text, file));
}

std::vector<std::string> knownSceneKeys() {
  TomlReader reader("", {});
  readScene(reader, "");
  return reader.knownKeys();
}

}  // namespace morphgrid
