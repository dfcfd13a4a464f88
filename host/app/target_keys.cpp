// Which surface to reach, and with what grid.
#include <numbers>

#include "app/scene_keys.h"
#include "core/key_place.h"
#include "surface/mesh_configuration.h"

namespace morphgrid {
namespace {

using Kinds = std::vector<std::size_t>;

const Kinds kPatch{0};
const Kinds kMesh{1};
const Kinds kBent{2};
const Kinds kMeasured{0, 1};

constexpr IntegerRange kRounds{0, 10000};
// Beyond it a printed strut keeps less of its shape.
constexpr double kMaxStrain = 0.03;

template <typename Value>
KeyPlace<Scene, Value> ofPatch(Value PatchRequest::*value) {
  return within<PatchRequest>(&Scene::surface, value);
}

template <typename Value>
KeyPlace<Scene, Value> ofMesh(Value MeshRequest::*value) {
  return within<MeshRequest>(&Scene::surface, value);
}

template <typename Value>
KeyPlace<Scene, Value> ofBends(Value BendAngleRequest::*value) {
  return within<BendAngleRequest>(&Scene::surface, value);
}

template <typename Value>
KeyPlace<Scene, Value> ofDesign(Value DesignRequest::*value) {
  return at(&Scene::design, value);
}

/// The alternative of the scene's surface.
WordKey<Scene> kindKey() {
  return {{[](const Scene& scene) { return std::optional(scene.surface.index()); },
           [](Scene& scene, std::size_t kind) { scene.surface = emptyRequest(kind); }},
          {kSurfaceWords.begin(), kSurfaceWords.end()}};
}

FileKey<Scene> meshConfigurationKey() {
  FileKey<Scene> key = fileKey(ofMesh(&MeshRequest::file), "mesh configuration");
  key.listNamed = [](const std::filesystem::path& file) {
    return std::vector{readMeshConfiguration(file).mesh};
  };
  return key;
}

SceneKey boxKey(const char* name, double SamplingBox::*value, const NumberRange& range,
                const char* meaning) {
  return {.name = name,
          .value = numberKey(within(&Scene::surface, &MeshRequest::box, value), range),
          .unit = "length",
          .kinds = kMesh,
          .defaultInWords = "required",
          .meaning = meaning};
}

SceneKey bendKey(const char* name, double BendAngleRequest::*first, double BendAngleRequest::*last,
                 const char* meaning) {
  constexpr double pi = std::numbers::pi;
  return {.name = name,
          .value = numberPairKey(ofBends(first), ofBends(last), fromTo(-pi, pi)),
          .unit = "rad",
          .kinds = kBent,
          .meaning = meaning};
}

}  // namespace

SceneKeySection surfaceKeys() {
  return {
      "surface",
      {
          {.name = "kind",
           .value = kindKey(),
           .isRequired = true,
           .meaning = "How the surface is given."},
          {.name = "patch",
           .value = fileKey(ofPatch(&PatchRequest::file)),
           .kinds = kPatch,
           .isRequired = true,
           .meaning = "The patch file, relative to the scene file."},
          {.name = "mesh",
           .value = meshConfigurationKey(),
           .kinds = kMesh,
           .isRequired = true,
           .meaning =
               "The mesh configuration, relative to the scene file; or the mesh itself, as it is."},
          boxKey("u_start", &SamplingBox::uStart, kCoordinates,
                 "Where the box of rays begins along u, the y axis."),
          boxKey("v_start", &SamplingBox::vStart, kCoordinates,
                 "Where it begins along v, the z axis."),
          boxKey("u_length", &SamplingBox::uLength, kLengths, "Its extent along u."),
          boxKey("v_length", &SamplingBox::vLength, kLengths, "Its extent along v."),
          {.name = "fill_holes",
           .value = numberKey(ofMesh(&MeshRequest::fillHoles), kWidths),
           .unit = "length",
           .kinds = kMesh,
           .meaning = "Where rays miss, holes up to this width are closed by interpolation from "
                      "their rim. Larger ones, and those at the box's edge, stop the run."},
          {.name = "steepest_slope",
           .value = numberKey(ofMesh(&MeshRequest::steepestSlope), above(0)),
           .kinds = kMesh,
           .meaning = "The steepest step in x between neighbouring rays, over their distance. A "
                      "steeper one is taken for an overhang seen from the side and stops the run."},
          {.name = "smoothing_width",
           .value = numberKey(ofMesh(&MeshRequest::smoothingWidth), kWidths),
           .unit = "length",
           .kinds = kMesh,
           .meaning = "Curvature is smoothed along the isolines over this width, for meshes that "
                      "are rough."},
          bendKey("theta_u", &BendAngleRequest::firstThetaU, &BendAngleRequest::lastThetaU,
                  "Bend angle of the first and last strut of every row along u, linear between. "
                  "Positive bends towards the top layer."),
          bendKey("theta_v", &BendAngleRequest::firstThetaV, &BendAngleRequest::lastThetaV,
                  "The same along v."),
          {.name = "spacing",
           .value = numberKey(ofBends(&BendAngleRequest::spacing), kLengths),
           .unit = "length",
           .kinds = kBent,
           .meaning = "Length of the lateral struts before they shrink."},
      }};
}

SceneKeySection gridKeys() {
  return {
      "grid",
      {
          {.name = "layers",
           .value = integerKey(ofDesign(&DesignRequest::layers), {1, 64}),
           .knob = KnobOffer{"layers"},
           .meaning = "Layers of the grid. One layer cannot bend."},
          {.name = "layer_spacing",
           .value = numberKey(ofDesign(&DesignRequest::layerSpacing), kLengths),
           .unit = "length",
           .isRequired = true,
           .knob = aroundItsValue("layer spacing"),
           .meaning = "Distance of neighbouring layers, tau in the paper. For surfaces that are "
                      "measured it is lowered where they curve too strongly for it (Eq. 21)."},
          {.name = "nodes_long",
           .value = integerKey(ofDesign(&DesignRequest::nodesLong), kCounts),
           .kinds = kMeasured,
           .knob = KnobOffer{"nodes"},
           .meaning = "Nodes along the longer direction; the other direction follows from the "
                      "aspect ratio (Eq. 22). Raised where the surface curves too strongly for so "
                      "few (Eq. 23), up to four times; where it takes more, the run stops and "
                      "says how many to ask for here."},
          {.name = "max_shrinkage",
           .value = numberKey(ofDesign(&DesignRequest::maxShrinkage), between(0, 1)),
           .unit = "share",
           .defaultInWords = "what `print.material` loses along its lines, else 0.4",
           .knob = KnobOffer{"max shrinkage", 0.05, 0.95},
           .meaning = "Share of its printed length that a strut can lose. Limits the layer spacing "
                      "of surfaces that are measured (Eq. 21); the report counts the struts over "
                      "it."},
          {.name = "curvature_cutoff",
           .value = numberKey(ofDesign(&DesignRequest::curvatureCutoff), aboveUpTo(0, 1)),
           .unit = "share",
           .kinds = kMeasured,
           .knob = KnobOffer{"cutoff p", 0.5, 1},
           .meaning = "Share of the measured curvatures that stay as they are; stronger ones are "
                      "capped to the largest of these. `morphgrid check` suggests one."},
          {.name = "strut_thickness",
           .value = numberKey(ofDesign(&DesignRequest::strutThickness), kLengths),
           .unit = "length",
           .meaning = "How thick a strut is printed. Where it is given, struts that come closer to "
                      "each other are reported."},
          {.name = "nodes_u",
           .value = integerKey(ofBends(&BendAngleRequest::nodesU), kCounts),
           .kinds = kBent,
           .isRequired = true,
           .meaning = "Nodes along u."},
          {.name = "nodes_v",
           .value = integerKey(ofBends(&BendAngleRequest::nodesV), kCounts),
           .kinds = kBent,
           .isRequired = true,
           .meaning = "Nodes along v."},
      }};
}

SceneKeySection designKeys() {
  return {
      "design",
      {
          {.name = "net",
           .value = wordKey(ofDesign(&DesignRequest::net), kNetWords),
           .kinds = kMeasured,
           .knob = KnobOffer{"net"},
           .meaning =
               "Lines along the isolines of the parameters, as in the paper; crossing at right "
               "angles, as corners that rest at right angles want it; or along the lines of "
               "curvature, as far as the target's sides allow, where welded layers share their "
               "joints' angles. The last two have their own ratio of the node counts, and struts "
               "that may differ much in length, see `max_strut_ratio`."},
          {.name = "layout",
           .value = wordKey(ofDesign(&DesignRequest::layout), kLayoutWords),
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 const bool isPapers = scene.material.model == Model::paper;
                 scene.design.layout = isPapers ? Layout::inPlane : Layout::conformal;
               },
           .defaultInWords = "`\"in_plane\"` for springs as in the paper, else `\"conformal\"`",
           .knob = KnobOffer{"layout"},
           .meaning = "How the flat sheet is laid out: square cells that morph in their plane, as "
                      "in the paper, or a sheet whose joints have the angles of the target and "
                      "whose scale fits the material's range, as welded joints want it."},
          {.name = "reference",
           .value = wordKey(ofDesign(&DesignRequest::reference), kReferenceWords),
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 const bool isPapers =
                     scene.design.net == NetKind::isoline && scene.design.layout == Layout::inPlane;
                 scene.design.reference = isPapers ? Reference::convex : Reference::middle;
               },
           .defaultInWords = "`\"convex\"` for `\"isoline\"` and `\"in_plane\"`, else `\"middle\"`",
           .knob = KnobOffer{"reference"},
           .meaning =
               "What has the target's lengths: each strut's convex side, as in the paper, or "
               "the middle of the layers, each of which then lies on an offset surface of "
               "the target. With `\"middle\"` the curvature cutoff bounds the layer spacing "
               "and the nodes, but caps no bend."},
          {.name = "max_strut_ratio",
           .value = numberKey(ofDesign(&DesignRequest::maxStrutRatio), above(1)),
           .kinds = kMeasured,
           .meaning = "The longest chord of an orthogonal or principal net may be so many times "
                      "the shortest: "
                      "the net is blended with the isolines as little as that takes."},
          {.name = "compensate",
           .value = integerKey(ofDesign(&DesignRequest::compensateRounds), kRounds),
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 if (scene.trueShape) scene.design.compensateRounds = kTrueShape.compensateRounds;
               },
           .defaultInWords = "0; 10 for `true_shape`",
           .knob = KnobOffer{"compensation rounds"},
           .meaning = "Rounds of spring-back correction. On a conformal sheet lengths are designed "
                      "anew for "
                      "points that lie beyond the target by as much as the grid fell short of it; "
                      "else they are multiplied by designed / simulated length. A round that comes "
                      "no closer is taken back."},
          {.name = "optimise",
           .value = integerKey(ofDesign(&DesignRequest::optimiseSteps), kRounds),
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 if (scene.trueShape) scene.design.optimiseSteps = kTrueShape.optimiseSteps;
               },
           .defaultInWords = "0; 20 for `true_shape`",
           .knob = KnobOffer{"optimiser steps"},
           .meaning = "Steps of adjoint optimisation of the lateral rest lengths, after the "
                      "correction. Both only for `solver.method = \"multigrid\"`."},
          {.name = "max_strain",
           .value = numberKey(ofDesign(&DesignRequest::maxStrain), between(0, 1)),
           .unit = "share",
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 if (scene.material.model != Model::paper) scene.design.maxStrain = kMaxStrain;
               },
           .defaultInWords = "no bound for springs as in the paper, else 0.03",
           .meaning = "By how much a lateral strut's length may differ from its rest length in the "
                      "end. Both of the above count what is beyond it as they count distance."},
          {.name = "enforce_shrinkage",
           .value = booleanKey(ofDesign(&DesignRequest::enforceShrinkage)),
           .kinds = kMeasured,
           .otherwise =
               [](Scene& scene) {
                 if (scene.trueShape) scene.design.enforceShrinkage = kTrueShape.enforceShrinkage;
               },
           .defaultInWords = "`false`; `true` for `true_shape`",
           .knob = KnobOffer{"enforce shrinkage"},
           .meaning =
               "Whether every strut shrinks by no less than `material.least_shrinkage` and no "
               "more than `grid.max_shrinkage`, or with `[print]` keeps to what it can by itself, "
               "on a sheet that is printed as large as "
               "that takes, or laid out for it; otherwise the two above stay within 30 % "
               "of the designed length."},
      }};
}

}  // namespace morphgrid
