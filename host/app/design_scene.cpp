#include "app/design_scene.h"

#include <fmt/format.h>

#include "app/mesh_sampler.h"
#include "core/error.h"
#include "measure/lattice_measurement.h"

namespace morphgrid {
namespace {

SceneDesign designMeasured(const SurfaceSurvey& survey, const DesignRequest& request,
                           const GridSize& size, SurfaceMeasurement measurement) {
  SceneDesign designed{designGrid(measurement, size, request.layers),
                       MeasurementFigures{survey.longestIsolineU, survey.longestIsolineV,
                                          survey.largestCurvature(), size.layerSpacingLimit,
                                          size.fewestNodes, listCutoffConsequences(survey, request),
                                          suggestCutoff(survey, request), std::nullopt},
                       std::move(measurement.points), std::nullopt, size.notices};
  const std::vector<std::string>& more = designed.design.notices;
  designed.notices.insert(designed.notices.end(), more.begin(), more.end());
  return designed;
}

SceneDesign designFromSurface(const Surface& surface, const DesignRequest& request) {
  const SurfaceSurvey survey = surveySurface(surface);
  const GridSize size = chooseGridSize(survey, request);
  return designMeasured(survey, request, size,
                        measureSurface(surface, size.nodesU, size.nodesV, size.curvatureLimit));
}

SceneDesign designFromMesh(const MeshTarget& target, const DesignRequest& request) {
  MeshSampler sampler(target);
  RayHits hits = sampler.cast(target.samplesU, target.samplesV);
  const LatticeSurvey survey = surveyLattice(hits.lattice(), target.smoothingWidth);
  const GridSize size = chooseGridSize(survey.survey, request);
  const RayHits vertexHits = sampler.cast(size.nodesU + 1, size.nodesV + 1);
  SceneDesign designed =
      designMeasured(survey.survey, request, size,
                     measureLattice(vertexHits.lattice(), size.curvatureLimit, target.smoothingWidth));
  designed.measurement->curvatureNoise = survey.curvatureNoise;
  designed.sampling = MeshSampling{std::move(hits), sampler.figures()};
  return designed;
}

const char* nameOf(Method method) {
  switch (method) {
    case Method::multigrid:
      return "multigrid";
    case Method::jacobi:
      return "jacobi";
    case Method::reference:
      break;
  }
  return "reference";
}

const char* nameOf(Scaling scaling) {
  return scaling == Scaling::normalised ? "normalised" : "shapeop";
}

}  // namespace

SceneDesign designScene(const Scene& scene) {
  try {
    if (scene.surface) {
      return designFromSurface(*scene.surface, scene.design);
    }
    if (scene.mesh) {
      return designFromMesh(*scene.mesh, scene.design);
    }
    return {designFromBendAngles(*scene.bendAngles), {}, {}, {}, {}};
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
  if (designed.sampling) {
    record.mesh = designed.sampling->figures;
  }
  record.published = scene.published;
  record.notices = designed.notices;
  return record;
}

}  // namespace morphgrid
