#include "app/design_scene.h"

#include <fmt/format.h>

#include <functional>

#include "app/mesh_sampler.h"
#include "core/error.h"
#include "measure/lattice_measurement.h"
#include "measure/orthogonal_net.h"

namespace morphgrid {
namespace {

/// Points along u and v of the lattice that a target is mapped from.
constexpr int kMapPoints = 161;

/// What a design asks of a target, be it a patch or a mesh.
struct SampledTarget {
  std::function<PointLattice(int countU, int countV)> lattice;  ///< At even parameters.
  NetPoints points;
  std::function<Eigen::Matrix3Xd(const Net&)> normals;
  std::function<SurfaceMeasurement(const PointLattice& netPoints, double curvatureLimit)> measure;
};

struct ChosenNet {
  Net net;
  PointLattice points;
  NetFigures figures;
};

ChosenNet chooseNet(const std::optional<ConformalMap>& map, const GridSize& size,
                    const DesignRequest& request, const NetPoints& pointsOf) {
  BlendedNet chosen{
      map ? orthogonalNet(*map, size.nodesU, size.nodesV) : isolineNet(size.nodesU, size.nodesV),
      0};
  if (map && request.maxStrutRatio) {
    chosen = boundStrutRatio(chosen.net, *request.maxStrutRatio, pointsOf);
    requireUnfolded(chosen.net);
  }
  PointLattice points = pointsOf(chosen.net);
  const NetQuality quality = assessNet(points);
  return {std::move(chosen.net),
          std::move(points),
          {request.net, map ? std::optional(map->modulus) : std::nullopt, chosen.blend, quality}};
}

void addNotices(std::vector<std::string>& notices, const ChosenNet& chosen,
                const DesignRequest& request, const GridDesign& design) {
  const double ratio = chosen.figures.quality.strutRatio;
  if (ratio > request.maxStrutRatio.value_or(ratio)) {
    notices.push_back(fmt::format(
        "the longest strut is {:.3g} times the shortest, beyond design.max_strut_ratio = {:g}: {}",
        ratio, *request.maxStrutRatio,
        request.net == NetKind::isoline ? "so the isolines run"
                                        : "no blend with the isolines does better"));
  }
  notices.insert(notices.end(), design.notices.begin(), design.notices.end());
}

SceneDesign designMeasured(const SurfaceSurvey& survey, const DesignRequest& request,
                           const SampledTarget& target) {
  std::optional<ConformalMap> map;
  if (request.net == NetKind::orthogonal) {
    map = mapConformally(target.lattice(kMapPoints, kMapPoints));
  }
  const GridSize size =
      chooseGridSize(survey, request, map ? std::optional(map->modulus) : std::nullopt);
  const ChosenNet chosen = chooseNet(map, size, request, target.points);
  SurfaceMeasurement measurement = target.measure(chosen.points, size.curvatureLimit);
  SceneDesign designed{
      request.reference == Reference::convex
          ? designGrid(measurement, size, request.layers)
          : designOnOffsets(measurement, target.normals(chosen.net), size, request.layers),
      MeasurementFigures{survey.longestIsolineU, survey.longestIsolineV, survey.largestCurvature(),
                         size.layerSpacingLimit, size.fewestNodes,
                         listCutoffConsequences(survey, request), suggestCutoff(survey, request),
                         std::nullopt},
      chosen.figures,
      std::move(measurement.points),
      std::nullopt,
      size.notices};
  addNotices(designed.notices, chosen, request, designed.design);
  return designed;
}

SceneDesign designFromSurface(const Surface& surface, const DesignRequest& request,
                              const Cancellation& cancellation) {
  const auto points = [&](const Net& net) {
    cancellation.check();
    return PointLattice{net.nodesU + 1, net.nodesV + 1, pointsAt(surface, net.parameters)};
  };
  return designMeasured(
      surveySurface(surface, cancellation), request,
      {.lattice = [&](int countU,
                      int countV) { return points(isolineNet(countU - 1, countV - 1)); },
       .points = points,
       .normals = [&](const Net& net) { return normalsAt(surface, net.parameters); },
       .measure =
           [&](const PointLattice& netPoints, double curvatureLimit) {
             return request.net == NetKind::isoline
                        ? measureSurface(surface, netPoints.countU - 1, netPoints.countV - 1,
                                         curvatureLimit, cancellation)
                        : measureLattice(netPoints, curvatureLimit, 0, cancellation);
           }});
}

SceneDesign designFromMesh(const MeshTarget& target, const DesignRequest& request,
                           const Cancellation& cancellation) {
  MeshSampler sampler(target, cancellation);
  RayHits hits = sampler.cast(target.samplesU, target.samplesV);
  const LatticeSurvey survey = surveyLattice(hits.lattice(), target.smoothingWidth, cancellation);
  const auto points = [&](const Net& net) {
    if (request.net == NetKind::isoline) {
      return sampler.cast(net.nodesU + 1, net.nodesV + 1).lattice();
    }
    return PointLattice{net.nodesU + 1, net.nodesV + 1, sampler.castThrough(net.parameters, hits)};
  };
  SceneDesign designed = designMeasured(
      survey.survey, request,
      {.lattice = [&](int countU, int countV) { return sampler.cast(countU, countV).lattice(); },
       .points = points,
       .normals = [&](const Net& net) { return sampler.normals(net.parameters, hits); },
       .measure =
           [&](const PointLattice& netPoints, double curvatureLimit) {
             return measureLattice(netPoints, curvatureLimit, target.smoothingWidth, cancellation);
           }});
  designed.measurement->curvatureNoise = survey.curvatureNoise;
  designed.sampling = MeshSampling{std::move(hits), sampler.figures()};
  return designed;
}

}  // namespace

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

SceneDesign designScene(const Scene& scene) {
  const Cancellation cancellation([&] { return scene.solve.stopRequested(); });
  try {
    if (scene.surface) {
      return designFromSurface(*scene.surface, scene.design, cancellation);
    }
    if (scene.mesh) {
      return designFromMesh(*scene.mesh, scene.design, cancellation);
    }
    return {designFromBendAngles(*scene.bendAngles), {}, {}, {}, {}, {}};
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
                 design.spacing,
                 design.layerSpacing,
                 100 * largestBendShrink(design)};
  record.measurement = designed.measurement;
  record.net = designed.net;
  if (designed.sampling) {
    record.mesh = designed.sampling->figures;
  }
  record.published = scene.published;
  record.notices = designed.notices;
  return record;
}

}  // namespace morphgrid
