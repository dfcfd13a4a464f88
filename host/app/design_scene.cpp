#include "app/design_scene.h"

#include <fmt/format.h>

#include "core/error.h"

namespace morphgrid {
namespace {

SceneDesign designFromSurface(const Surface& surface, const DesignRequest& request) {
  const SurfaceSurvey survey = surveySurface(surface);
  const GridSize size = chooseGridSize(survey, request);
  SurfaceMeasurement measurement =
      measureSurface(surface, size.nodesU, size.nodesV, size.curvatureLimit);
  SceneDesign designed{designGrid(measurement, size, request.layers),
                       MeasurementFigures{survey.longestIsolineU, survey.longestIsolineV,
                                          survey.largestCurvature(), size.layerSpacingLimit,
                                          size.fewestNodes, listCutoffConsequences(survey, request),
                                          suggestCutoff(survey, request), std::nullopt},
                       std::move(measurement.points), size.notices};
  const std::vector<std::string>& more = designed.design.notices;
  designed.notices.insert(designed.notices.end(), more.begin(), more.end());
  return designed;
}

const char* nameOf(Method method) { return method == Method::jacobi ? "jacobi" : "reference"; }

const char* nameOf(Scaling scaling) {
  return scaling == Scaling::normalised ? "normalised" : "shapeop";
}

}  // namespace

SceneDesign designScene(const Scene& scene) {
  try {
    if (scene.surface) {
      return designFromSurface(*scene.surface, scene.design);
    }
    return {designFromBendAngles(*scene.bendAngles), std::nullopt, std::nullopt, {}};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), error.what()));
  }
}

RunRecord recordOf(const Scene& scene, const SceneDesign& designed) {
  const GridDesign& design = designed.design;
  RunRecord record;
  record.scene = scene.name;
  record.title = scene.title;
  record.method = nameOf(scene.method);
  record.scaling = nameOf(scene.scaling);
  record.grid = {{design.nodesU + 1, design.nodesV + 1, design.layers},
                 design.layerSpacing,
                 100 * largestBendShrink(design)};
  record.measurement = designed.measurement;
  record.published = scene.published;
  record.notices = designed.notices;
  return record;
}

}  // namespace morphgrid
