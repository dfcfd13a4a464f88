#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/print_section.h"
#include "design/build_grids.h"
#include "design/grid_design.h"
#include "design/material.h"
#include "report/run_record.h"
#include "solve/equilibrium.h"
#include "target/target_request.h"

namespace morphgrid {

enum class Method { multigrid, jacobi, reference };

// As scene files call them.
inline constexpr std::array kMethodWords = {"multigrid", "jacobi", "reference"};
inline constexpr std::array kScalingWords = {"normalised", "shapeop"};
inline constexpr std::array kSurfaceWords = {"bezier", "mesh", "bend_angles"};
constexpr const char* nameOf(Method method) {
  return kMethodWords[static_cast<std::size_t>(method)];
}
constexpr const char* nameOf(Scaling scaling) {
  return kScalingWords[static_cast<std::size_t>(scaling)];
}

struct PictureChoices {
  bool enabled = true;
  int width = 1280;
  int height = 960;
};

struct FileChoices {
  bool gltf = true;
  bool vtu = true;
  bool ply = true;
  bool obj = true;
  int mostObjFaces = 1000000;  ///< A surface of more is left out.
  bool state = true;
};

/// How the surface is given; in the order of kSurfaceWords.
using SurfaceRequest = std::variant<PatchRequest, MeshRequest, BendAngleRequest>;

/// What one scene file asks for, read and checked.
struct Scene {
  std::string name;   ///< The file's stem.
  std::string title;  ///< For people; the name when the file has none.
  std::filesystem::path file;
  std::string text;        ///< The whole scene, see sceneText().
  bool trueShape = false;  ///< Whether what is not said otherwise is as kTrueShape has it.
  SurfaceRequest surface;
  DesignRequest design;
  MaterialRequest material;
  std::optional<ScenePrint> print;
  Weights weights;
  Scaling scaling = Scaling::normalised;
  Method method = Method::multigrid;
  SolveOptions solve;
  bool smallestEigenvalue = false;  ///< Whether to find out if the equilibria are minima.
  PictureChoices pictures;
  FileChoices files;
  std::optional<PublishedFigures> published;
};

/// Reads a TOML scene and the TOML files that it names; overrides are `key=value` with dotted keys,
/// e.g. "grid.layers=4", applied before the checks. Throws InputError with every problem of the
/// files, one a line, each as `file:line:column: what is wrong, what is allowed, what was found`.
Scene loadScene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same of a text that stands alone, see sceneText(); file: what errors name.
Scene loadSceneText(const std::string& text, const std::filesystem::path& file,
                    const std::string& name, const std::vector<std::string>& overrides = {});

/// The dotted names of all keys that a scene file may hold, in the order of the documentation.
std::vector<std::string> knownSceneKeys();

}  // namespace morphgrid
