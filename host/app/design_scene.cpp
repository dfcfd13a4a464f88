#include "app/design_scene.h"

#include <fmt/format.h>

#include "core/error.h"
#include "measure/conformal_map.h"
#include "measure/mapped_net.h"
#include "measure/principal_map.h"

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

/// What the net is drawn on; isolines need none.
std::optional<LatticeMap> mapFor(NetKind net, TargetSampler& sampler) {
  if (net == NetKind::isoline) {
    return std::nullopt;
  }
  const Net lattice = isolineNet(kMapNodes, kMapNodes);
  const PointLattice points = sampler.points(lattice);
  return net == NetKind::orthogonal ? mapConformally(points)
                                    : mapAlongCurvature(points, sampler.normals(lattice));
}

ChosenNet chooseNet(const std::optional<LatticeMap>& map, const GridSize& size,
                    const DesignRequest& request, const NetPoints& pointsOf) {
  BlendedNet chosen{
      map ? mappedNet(*map, size.nodesU, size.nodesV) : isolineNet(size.nodesU, size.nodesV), 0};
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

double meanOf(const LateralField<double>& values) {
  double sum = 0;
  forEachLateralStrut(values.shape(), [&](const Strut& strut) { sum += values.at(strut); });
  return sum / values.shape().lateralStrutCount();
}

/// Where its sheet is laid out, the scale at which a grid is printed, and the bars' sizes and the
/// lengths that follow from it depend on each other, but little.
constexpr int kScaleRounds = 4;

/// What lengths are designed from.
struct Measured {
  const SurfaceMeasurement& surface;
  const GridSize& size;
};

void layOut(SceneDesign& designed, const ShrinkBounds& shrink, const Cancellation& cancellation) {
  const GridDesign& design = designed.design;
  const SheetProblem problem{.layer = design.rest.front().shape(),
                             .points = *designed.targets,
                             .normals = designed.normals,
                             .rest = design.rest,
                             .shrink = shrink};
  Sheet sheet = layConformally(problem, cancellation);
  const SheetFigures figures = computeSheetFigures(problem, sheet, design.layerSpacing);
  designed.angleErrors = printedAngleErrors(problem, sheet);
  designed.sheet = LaidSheet{std::move(sheet), figures};
}

/// The rest lengths, and the sheet of Layout::conformal, of a grid that is printed at this scale.
void designLengths(SceneDesign& designed, const Scene& scene, const Measured& measured,
                   const std::optional<double>& mmPerUnit, const Cancellation& cancellation) {
  const DesignRequest& request = scene.design;
  const SurfaceMeasurement& surface = measured.surface;
  const double barHeight =
      scene.material.model == Model::frame
          ? barSizesOf(materialOf(scene, mmPerUnit), meanOf(surface.chords)).height
          : 0;
  designed.stack = {request.layers, measured.size.layerSpacing, barHeight};
  designed.design = request.reference == Reference::convex
                        ? designGrid(surface, measured.size, request.layers)
                        : designOnOffsets(surface, designed.normals, designed.stack);
  if (request.layout == Layout::conformal) {
    layOut(designed, shrinkBoundsOf(scene, mmPerUnit), cancellation);
  }
}

/// About the sheet of a target: a rectangle as long as its longest isolines, enlarged by half of
/// what the material loses.
Eigen::Matrix2Xd roughSheet(const Scene& scene, const SurfaceSurvey& survey) {
  const double larger = 1 / (1 - scene.design.maxShrinkage / 2);
  Eigen::Matrix2Xd corners(2, 2);
  corners << 0, larger * survey.longestIsolineU, 0, larger * survey.longestIsolineV;
  return corners;
}

/// Where the scene leaves the scale out, and a sheet is laid out, by turns: lengths and sheet for a
/// scale, then the scale for the sheet.
void designForPrint(SceneDesign& designed, const Scene& scene, const Measured& measured,
                    const SurfaceSurvey& survey, const Cancellation& cancellation) {
  std::optional<double> scale = mmPerUnitOf(scene, roughSheet(scene, survey));
  designLengths(designed, scene, measured, scale, cancellation);
  if (scene.print && scene.print->tools.request.scale) {
    designed.mmPerUnit = scale;
  }
  if (!scene.print || !designed.sheet || designed.mmPerUnit) {
    return;
  }
  designed.mmPerUnit = mmPerUnitOf(scene, designed.sheet->sheet.positions);
  for (int round = 1; round < kScaleRounds && designed.mmPerUnit != scale; ++round) {
    scale = designed.mmPerUnit;
    designLengths(designed, scene, measured, scale, cancellation);
    designed.mmPerUnit = mmPerUnitOf(scene, designed.sheet->sheet.positions);
  }
}

/// Nodes that Eq. 23 has raised may be so close that their rays find what those asked for do not.
template <typename Choose>
ChosenNet naming(const GridSize& size, const DesignRequest& request, const SurfaceSurvey& survey,
                 const Choose& choose) {
  try {
    return choose();
  } catch (const InputError& error) {
    if (std::max(size.nodesU, size.nodesV) <= request.nodesLong) throw;
    const auto cutoff = suggestCutoff(survey, request);
    throw InputError(fmt::format(
        "{}\n{} nodes were raised to {} for curvature up to {:.4g} (Eq. 23), whose rays are so "
        "close{}",
        error.what(), request.nodesLong, std::max(size.nodesU, size.nodesV), size.curvatureLimit,
        cutoff
            ? fmt::format(": grid.curvature_cutoff = {:g} keeps those that were asked for", *cutoff)
            : ""));
  }
}

SceneDesign designFor(const Scene& scene, const std::shared_ptr<const Target>& target,
                      const RequireShape& requireShape, const Cancellation& cancellation) {
  const DesignRequest& request = scene.design;
  const std::unique_ptr<TargetSampler> sampler = target->sampler(cancellation);
  const SurfaceSurvey& survey = target->survey();
  const std::optional<LatticeMap> map = mapFor(request.net, *sampler);
  const GridSize size =
      chooseGridSize(survey, request, map ? std::optional(map->modulus) : std::nullopt);
  if (requireShape) requireShape({size.nodesU + 1, size.nodesV + 1, request.layers});
  const ChosenNet chosen = naming(size, request, survey, [&] {
    return chooseNet(map, size, request, [&](const Net& net) { return sampler->points(net); });
  });
  const SurfaceMeasurement measurement =
      sampler->measure(chosen.net, chosen.points, size.curvatureLimit);
  Eigen::Matrix3Xd normals;
  if (request.reference == Reference::middle || request.layout == Layout::conformal) {
    normals = sampler->normals(chosen.net);
  }
  SceneDesign designed{target,
                       {},
                       MeasurementFigures{survey.longestIsolineU, survey.longestIsolineV,
                                          survey.largestCurvature(), size.layerSpacingLimit,
                                          size.fewestNodes, listCutoffConsequences(survey, request),
                                          suggestCutoff(survey, request), target->curvatureNoise()},
                       chosen.figures,
                       measurement.points,
                       std::move(normals),
                       {},
                       {},
                       sampler->meshFigures(),
                       target->notices()};
  designed.notices.insert(designed.notices.end(), size.notices.begin(), size.notices.end());
  designForPrint(designed, scene, {measurement, size}, survey, cancellation);
  if (designed.sheet) {
    const auto advice =
        adviseOn(designed.sheet->figures, shrinkBoundsOf(scene, designed.mmPerUnit));
    designed.notices.insert(designed.notices.end(), advice.begin(), advice.end());
  }
  addNotices(designed.notices, chosen, request, designed.design);
  return designed;
}

}  // namespace

SceneDesign designScene(const Scene& scene, const std::shared_ptr<const Target>& target,
                        const RequireShape& requireShape) {
  try {
    if (target) {
      return designFor(scene, target, requireShape, cancellationOf(scene));
    }
    const auto& bendAngles = std::get<BendAngleRequest>(scene.surface);
    if (requireShape) {
      requireShape({bendAngles.nodesU + 1, bendAngles.nodesV + 1, scene.design.layers});
    }
    SceneDesign designed{
        nullptr, designFromBendAngles(bendAngles, scene.design.layers, scene.design.layerSpacing)};
    if (scene.print) {
      designed.mmPerUnit = scene.print->tools.request.scale;
    }
    return designed;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", scene.file.string(), error.what()));
  }
}

SceneDesign designScene(const Scene& scene, const RequireShape& requireShape) {
  return designScene(scene, loadTarget(scene, cancellationOf(scene)), requireShape);
}

std::shared_ptr<const SceneDesign> DesignKeeper::designOf(
    const Scene& scene, const std::shared_ptr<const Target>& target) {
  // Bend angles have no target: they are the surface's own keys.
  if (!design_ || design_->target != target || surface_ != scene.surface ||
      request_ != scene.design || material_ != scene.material || print_ != scene.print) {
    design_ = std::make_shared<const SceneDesign>(designScene(scene, target));
    surface_ = scene.surface;
    request_ = scene.design;
    material_ = scene.material;
    print_ = scene.print;
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
  if (designed.sheet) {
    record.sheet = designed.sheet->figures;
    record.printedSheet = {record.sheet->sizeX, record.sheet->sizeY};
  }
  if (scene.print && designed.mmPerUnit) {
    record.print = assessmentBy(scene.print->tools);
    record.print->scale = *designed.mmPerUnit;
  }
  record.mesh = designed.mesh;
  record.published = scene.published;
  record.notices.assign(designed.notices.begin(), designed.notices.end());
  return record;
}

}  // namespace morphgrid
