#include "app/design_scene.h"

#include <fmt/format.h>

#include "core/error.h"
#include "measure/orthogonal_net.h"

namespace morphgrid {
namespace {

/// Along u and v, of the net that a target is mapped from.
constexpr int kMapNodes = 160;

Cancellation cancellationOf(const Scene& scene) {
  return Cancellation([&] { return scene.solve.stopRequested(); });
}

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

SceneDesign designFor(const std::shared_ptr<const Target>& target, const DesignRequest& request,
                      const Cancellation& cancellation) {
  const std::unique_ptr<TargetSampler> sampler = target->sampler(cancellation);
  const SurfaceSurvey& survey = target->survey();
  std::optional<ConformalMap> map;
  if (request.net == NetKind::orthogonal) {
    map = mapConformally(sampler->points(isolineNet(kMapNodes, kMapNodes)));
  }
  const GridSize size =
      chooseGridSize(survey, request, map ? std::optional(map->modulus) : std::nullopt);
  const ChosenNet chosen =
      chooseNet(map, size, request, [&](const Net& net) { return sampler->points(net); });
  SurfaceMeasurement measurement = sampler->measure(chosen.net, chosen.points, size.curvatureLimit);
  SceneDesign designed{
      target,
      request.reference == Reference::convex
          ? designGrid(measurement, size, request.layers)
          : designOnOffsets(measurement, sampler->normals(chosen.net), size, request.layers),
      MeasurementFigures{survey.longestIsolineU, survey.longestIsolineV, survey.largestCurvature(),
                         size.layerSpacingLimit, size.fewestNodes,
                         listCutoffConsequences(survey, request), suggestCutoff(survey, request),
                         target->curvatureNoise()},
      chosen.figures,
      std::move(measurement.points),
      sampler->meshFigures(),
      size.notices};
  addNotices(designed.notices, chosen, request, designed.design);
  return designed;
}

}  // namespace

SceneDesign designScene(const Scene& scene, const std::shared_ptr<const Target>& target) {
  try {
    if (target) {
      return designFor(target, scene.design, cancellationOf(scene));
    }
    const auto& bendAngles = std::get<BendAngleRequest>(scene.surface);
    return {nullptr,
            designFromBendAngles(bendAngles, scene.design.layers, scene.design.layerSpacing)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), error.what()));
  }
}

SceneDesign designScene(const Scene& scene) {
  return designScene(scene, loadTarget(scene, cancellationOf(scene)));
}

std::shared_ptr<const SceneDesign> DesignKeeper::designOf(
    const Scene& scene, const std::shared_ptr<const Target>& target) {
  // Bend angles have no target: they are the surface's own keys.
  if (!design_ || design_->target != target || surface_ != scene.surface ||
      request_ != scene.design) {
    design_ = std::make_shared<const SceneDesign>(designScene(scene, target));
    surface_ = scene.surface;
    request_ = scene.design;
  }
  return design_;
}

RunRecord recordOf(const Scene& scene, const SceneDesign& designed) {
  const GridDesign& design = designed.design;
  RunRecord record;
  record.scene = scene.name;
  record.title = scene.title;
  record.method = nameOf(scene.method);
  record.scaling = nameOf(scene.scaling);
  record.model = nameOf(scene.material.model);
  record.grid = {{design.nodesU + 1, design.nodesV + 1, design.layers},
                 design.spacing,
                 design.layerSpacing,
                 100 * largestBendShrink(design)};
  record.measurement = designed.measurement;
  record.net = designed.net;
  record.mesh = designed.mesh;
  record.published = scene.published;
  record.notices = designed.notices;
  return record;
}

}  // namespace morphgrid
