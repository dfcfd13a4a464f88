#include "app/problem_identity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/digest.h"
#include "design/build_grids.h"

namespace morphgrid {
namespace {

std::span<const double> allOf(const Eigen::Matrix3Xd& points) {
  return {points.data(), static_cast<std::size_t>(points.size())};
}

void addStrutValues(Digest& digest, const StrutValues& values) {
  digest.addList(values.u).addList(values.v).addList(values.w);
}

void addGrid(Digest& digest, const StrutGrid& grid) {
  for (const int count : {grid.shape.verticesU, grid.shape.verticesV, grid.shape.layers}) {
    digest.add(std::int64_t{count});
  }
  digest.add(grid.spacing);
  for (const TermWeight& weight : kTermWeights) digest.add(grid.weights.*weight.value);
  digest.addList(allOf(grid.positions));
  addStrutValues(digest, grid.rest);
  addStrutValues(digest, grid.stiffness);
  if (grid.bars) {
    for (const BarSection& bar : {grid.bars->lateral, grid.bars->upright}) {
      for (const double value :
           {bar.stretching, bar.bendingN, bar.bendingB, bar.twisting, bar.shearing, bar.joint}) {
        digest.add(value);
      }
    }
    if (const auto& loads = grid.bars->loads) {
      digest.addList(allOf(loads->forces));
      for (const int joint : loads->held) digest.add(std::int64_t{joint});
      digest.add(std::int64_t{loads->slide});
    }
  }
  if (grid.printedCorners) digest.addList(allOf(*grid.printedCorners));
}

/// What bounds inverse design, and all that it follows from.
void addShrinkage(Digest& digest, const Scene& scene) {
  const bool isEnforced = scene.design.enforceShrinkage;
  digest.add(isEnforced ? scene.design.maxShrinkage : 0.0);
  digest.add(isEnforced ? scene.material.leastShrinkage : 0.0);
  if (!scene.print) return;
  const PrintTools& tools = scene.print->tools;
  const ShrinkBounds bounds = shrinkBoundsOf(tools, 1);
  const PrintedBars bars = printedBarsOf(tools);
  for (const double value :
       {bounds.material.least, bounds.material.most, bounds.hub, bounds.hubDiameter, bars.width,
        bars.height, tools.request.scale.value_or(0), tools.printer.bedX, tools.printer.bedY,
        tools.printer.margin}) {
    digest.add(value);
  }
}

std::string describePrint(const Scene& scene) {
  if (!scene.print) {
    return "none";
  }
  const PrintTools& tools = scene.print->tools;
  return fmt::format("{} on {}, hubs of {:.2f} mm, {}", tools.material.name, tools.printer.name,
                     2 * printedBarsOf(tools).joint,
                     tools.request.scale ? fmt::format("{:g} mm per unit", *tools.request.scale)
                                         : "as large as fits");
}

std::string describeWeight(const MaterialRequest& material) {
  if (!material.gravity) {
    return "none";
  }
  return fmt::format("gravity [{}], density {} in {}, modulus {}, unit {} m",
                     fmt::join(*material.gravity, ", "), *material.density, material.fluidDensity,
                     *material.modulus, material.unit);
}

std::string describeSupports(const MaterialRequest& material) {
  std::vector<std::string> texts;
  for (const Support& support : material.supports) {
    const auto* place = std::get_if<SupportPlace>(&support);
    texts.push_back(place ? kSupportWords[static_cast<std::size_t>(*place)]
                          : fmt::format("[{}]", fmt::join(std::get<1>(support), ", ")));
  }
  return texts.empty()
             ? "none"
             : fmt::format("{}{}", fmt::join(texts, ", "), material.slide ? ", slide" : "");
}

std::string describe(const Weights& weights) {
  return fmt::format("lateral {}, vertical {}, angle {}", weights.lateral, weights.vertical,
                     weights.angle);
}

std::string digestOfProblem(const Scene& scene, const SceneDesign& designed) {
  Digest digest;
  digest.addList(std::string_view(nameOf(scene.method)));
  const StrutGrid flat = inPlaneGrid(designed.design, scene.weights, scene.scaling);
  addGrid(digest, flat);
  if (designed.design.layers > 1) {
    // On the sheet as it is before the stage in the plane: where that ends is in the checkpoint.
    StrutGrid stacked = stackedGrid(designed.design, scene.weights, scene.scaling, flat.positions);
    applyMaterial(stacked, materialOf(scene, designed.mmPerUnit));
    addGrid(digest, stacked);
    if (designed.sheet) {
      const Eigen::Matrix2Xd& sheet = designed.sheet->sheet.positions;
      digest.addList(std::span(sheet.data(), static_cast<std::size_t>(sheet.size())));
    }
    addShrinkage(digest, scene);
    digest.add(scene.design.maxStrain.value_or(0));
    digest.addList(allOf(designed.targets.value_or(Eigen::Matrix3Xd(3, 0))));
  }
  return digest.text();
}

}  // namespace

ProblemIdentity identifyProblem(const Scene& scene, const SceneDesign& designed) {
  const GridDesign& design = designed.design;
  const DesignRequest& request = scene.design;
  return {
      digestOfProblem(scene, designed),
      {
          {"nodes", fmt::format("{} x {}", design.nodesU, design.nodesV)},
          {"layers", fmt::format("{}", design.layers)},
          {"layer spacing", fmt::format("{}", design.layerSpacing)},
          {"spacing", fmt::format("{}", design.spacing)},
          {"weights", describe(scene.weights)},
          {"scaling", nameOf(scene.scaling)},
          {"model", nameOf(scene.material.model)},
          {"weight", describeWeight(scene.material)},
          {"supports", describeSupports(scene.material)},
          {"method", nameOf(scene.method)},
          {"curvature cutoff", fmt::format("{}", request.curvatureCutoff)},
          {"net", nameOf(request.net)},
          {"reference", request.reference == Reference::middle ? "middle" : "convex"},
          {"layout", nameOf(request.layout)},
          {"enforced shrinkage",
           request.enforceShrinkage
               ? fmt::format("{} to {}", scene.material.leastShrinkage, request.maxShrinkage)
               : "none"},
          {"print", describePrint(scene)},
          {"largest strain", request.maxStrain ? fmt::format("{}", *request.maxStrain) : "none"},
      },
  };
}

std::string describeDifferences(const ProblemIdentity& checkpoint, const ProblemIdentity& scene) {
  std::string differences;
  for (const auto& [name, wanted] : scene.settings) {
    const auto found = checkpoint.settings.find(name);
    const std::string had = found == checkpoint.settings.end() ? "unknown" : found->second;
    if (had != wanted) {
      differences +=
          fmt::format("\n  {}: {} in the checkpoint, {} in the scene", name, had, wanted);
    }
  }
  return differences.empty() ? "\n  the surface, its sampling or the lengths designed from it"
                             : differences;
}

}  // namespace morphgrid
