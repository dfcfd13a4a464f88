// What a scene asks for besides its target: how to solve and what to write.
#include "app/scene_keys.h"

#include "core/key_place.h"

namespace morphgrid {
namespace {

const std::vector<std::size_t> kMeasuredSurfaces{0, 1};
constexpr IntegerRange kPixels{64, 8192};
constexpr IntegerRange kFaces{0, 2000000000};

// Far beyond what a grid that converges needs: tens of cycles, thousands of simple iterations.
constexpr long kCycleLimit = 5000;

SceneKeySection topKeys() {
  return {"",
          {
              {.name = "extends",
               // parseToml() has followed it.
               .value = CustomKey<Scene>{[](TomlReader& reader, Scene&) {
                                           reader.root().text("extends");
                                         },
                                         "string", "a readable file"},
               .meaning = "Another scene, relative to this file. It gives the keys that this file "
                          "leaves out, and may extend a third one."},
              {.name = "true_shape",
               .value = booleanKey(at(&Scene::trueShape)),
               .kinds = kMeasuredSurfaces,
               .knob = KnobOffer{"true shape"},
               .meaning = "Whether to ask for lengths that bring the simulated grid to its target, "
                          "as it is printed: other defaults for `material.model`, "
                          "`material.least_shrinkage`, `design.compensate`, `design.optimise` and "
                          "`design.enforce_shrinkage`."},
              {.name = "title",
               .value = textKey(at(&Scene::title)),
               .otherwise = [](Scene& scene) { scene.title = scene.name; },
               .defaultInWords = "the file's name",
               .meaning = "What reports and windows call the scene."},
          }};
}

SceneKeySection weightKeys() {
  return {"weights",
          {
              {.name = "lateral",
               .value = numberKey(at(&Scene::weights, &Weights::lateral), kWeights),
               .knob = aroundItsValue("weight lateral"),
               .meaning = "Weight of struts within a layer."},
              {.name = "vertical",
               .value = numberKey(at(&Scene::weights, &Weights::vertical), kWeights),
               .knob = aroundItsValue("weight vertical"),
               .meaning = "Weight of struts between layers."},
              {.name = "angle",
               .value = numberKey(at(&Scene::weights, &Weights::angle), fromTo(0, kWeights.high)),
               .knob = KnobOffer{"weight angle", 0, 10},
               .meaning = "Weight of corners, which rest at 90 degrees."},
          }};
}

SceneKeySection solverKeys() {
  return {
      "solver",
      {
          {.name = "method",
           .value = wordKey(at(&Scene::method), kMethodWords),
           .knob = KnobOffer{"method"},
           .meaning = "`\"multigrid\"` needs tens of iterations at any size, on the GPU; "
                      "`\"jacobi\"` is the simple method on the GPU, slow on all but small grids; "
                      "`\"reference\"` runs on the CPU in double precision, slow on large grids."},
          {.name = "scaling",
           .value = wordKey(at(&Scene::scaling), kScalingWords),
           .meaning = "How strut energies are scaled. `\"normalised\"` gives the same shape in "
                      "every unit of length; `\"shapeop\"` does not, and is there to compare with "
                      "the paper."},
          {.name = "tolerance",
           .value = numberKey(at(&Scene::solve, &SolveOptions::tolerance), between(0, 1)),
           .knob = KnobOffer{"tolerance", 1e-10, 1e-3, true},
           .meaning = "The solver stops when the residual falls below it."},
          {.name = "energy_tolerance",
           .value = numberKey(at(&Scene::solve, &SolveOptions::energyTolerance),
                              NumberRange{.low = 0, .high = 1, .lowIncluded = true}),
           .unit = "share",
           .meaning = "`\"multigrid\"` also stops when three iterations in a row could not have "
                      "lowered the energy by more than this share of it, and the others do "
                      "not stop while more than this share is left. `0`: only the residual "
                      "counts."},
          {.name = "iteration_limit",
           .value = integerKey(at(&Scene::solve, &SolveOptions::iterationLimit), {.low = 0}),
           .otherwise =
               [](Scene& scene) {
                 if (scene.method == Method::multigrid) scene.solve.iterationLimit = kCycleLimit;
               },
           .meaning = "The solver stops after as many iterations, converged or not. "
                      "`\"multigrid\"` counts cycles on the finest grid. The default of the other "
                      "methods is 200000."},
          {.name = "smallest_eigenvalue",
           .value = booleanKey(at(&Scene::smallestEigenvalue)),
           .meaning = "Whether to find out if the equilibria are minima or saddles, see "
                      "[report.md](report.md). The flag `--smallest-eigenvalue` of `morphgrid run` "
                      "asks for it too."},
      }};
}

SceneKey pixelsKey(const char* name, int PictureChoices::*pixels, const char* meaning) {
  return {.name = name,
          .value = integerKey(at(&Scene::pictures, pixels), kPixels),
          .unit = "pixels",
          .meaning = meaning};
}

SceneKey formatKey(const char* name, bool FileChoices::*choice, const char* meaning) {
  return {.name = name, .value = booleanKey(at(&Scene::files, choice)), .meaning = meaning};
}

SceneKeySection outputKeys() {
  return {"output",
          {
              {.name = "pictures",
               .value = booleanKey(at(&Scene::pictures, &PictureChoices::enabled)),
               .meaning = "Whether to render pictures."},
              pixelsKey("width", &PictureChoices::width, "Width of the pictures."),
              pixelsKey("height", &PictureChoices::height, "Height of the pictures."),
              formatKey("gltf", &FileChoices::gltf, "Whether to write glTF."),
              formatKey("vtu", &FileChoices::vtu, "Whether to write VTK's unstructured grid."),
              formatKey("ply", &FileChoices::ply, "Whether to write PLY."),
              formatKey("obj", &FileChoices::obj, "Whether to write OBJ."),
              {.name = "most_obj_faces",
               .value = integerKey(at(&Scene::files, &FileChoices::mostObjFaces), kFaces),
               .meaning = "A surface of more triangles is not written as OBJ, text of about 110 "
                          "bytes a triangle; PLY holds it."},
              formatKey("state", &FileChoices::state,
                        "Whether to write the [state](state_format.md), from which other commands "
                        "go on."),
          }};
}

SceneKey paperKey(const char* name, std::optional<double> PublishedFigures::*figure,
                  const NumberRange& range, const char* unit, const char* meaning) {
  return {.name = name,
          .value = numberKey(at(&Scene::published, figure), range),
          .unit = unit,
          .meaning = meaning};
}

SceneKey paperKey(const char* name, std::optional<int> PublishedFigures::*figure,
                  const char* meaning) {
  return {.name = name,
          .value = integerKey(at(&Scene::published, figure), kCounts),
          .meaning = meaning};
}

SceneKeySection paperKeys() {
  using Paper = PublishedFigures;
  return {
      "paper",
      {
          {.name = "figure",
           .value = textKey(at(&Scene::published, &Paper::figure)),
           .meaning = "Which figure, e.g. `\"Fig. 4\"`."},
          paperKey("longest_isoline_u", &Paper::longestIsolineU, above(0), "length",
                   "Longest isoline along u."),
          paperKey("longest_isoline_v", &Paper::longestIsolineV, above(0), "length",
                   "Longest isoline along v."),
          paperKey("largest_curvature", &Paper::largestCurvature, atLeast(0), "1 / length",
                   "Largest curvature of the isolines."),
          paperKey("nodes_u", &Paper::nodesU, "Nodes along u."),
          paperKey("nodes_v", &Paper::nodesV, "Nodes along v."),
          paperKey("bend_shrink_percent", &Paper::bendShrinkPercent, atLeast(0), "%",
                   "Largest share that a strut loses to make the surface bend."),
          paperKey("l0_percent", &Paper::l0Percent, atLeast(0), "%",
                   "Mean error of the strut lengths on the layer that carries the surface's own "
                   "lengths."),
          paperKey("lb_percent", &Paper::lbPercent, atLeast(0), "%",
                   "The same on the opposite layer, which shrinks the most."),
          paperKey("angle_percent", &Paper::anglePercent, atLeast(0), "%",
                   "Mean error of the corners, in % of 90 degrees."),
      }};
}

}  // namespace

KnobOffer aroundItsValue(std::string label) {
  return {
      .label = std::move(label), .low = 0.2, .high = 5, .isLogarithmic = true, .isRelative = true};
}

const std::vector<SceneKeySection>& sceneKeys() {
  static const std::vector<SceneKeySection> kSections = {
      topKeys(),    surfaceKeys(), materialKeys(), printKeys(),  gridKeys(),
      designKeys(), weightKeys(),  solverKeys(),   outputKeys(), paperKeys()};
  return kSections;
}

const RecordKinds<Scene>& sceneKinds() {
  static const RecordKinds<Scene> kKinds{
      {kSurfaceWords.begin(), kSurfaceWords.end()},
      [](std::size_t kind) { return Scene{.surface = emptyRequest(kind)}; }};
  return kKinds;
}

SurfaceRequest emptyRequest(std::size_t kind) {
  switch (kind) {
    case 0:
      return PatchRequest();
    case 1:
      return MeshRequest();
    default:
      return BendAngleRequest();
  }
}

}  // namespace morphgrid
