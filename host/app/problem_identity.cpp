#include "app/problem_identity.h"

#include <fmt/format.h>

#include "core/binary_file.h"
#include "design/build_grids.h"

namespace morphgrid {
namespace {

void addStrutValues(BinaryWriter& writer, const StrutValues& values) {
  writer.numbers(values.u).numbers(values.v).numbers(values.w);
}

void addGrid(BinaryWriter& writer, const StrutGrid& grid) {
  writer.integer(grid.shape.verticesU).integer(grid.shape.verticesV).integer(grid.shape.layers);
  writer.number(grid.spacing).points(grid.positions).number(grid.angleWeight);
  addStrutValues(writer, grid.rest);
  addStrutValues(writer, grid.stiffness);
}

std::string digestOfProblem(const Scene& scene, const SceneDesign& designed) {
  BinaryWriter writer;
  writer.text(nameOf(scene.method));
  const StrutGrid flat = inPlaneGrid(designed.design, scene.weights, scene.scaling);
  addGrid(writer, flat);
  if (designed.design.layers > 1) {
    // On the sheet as it is before the stage in the plane: where that ends is in the checkpoint.
    addGrid(writer, stackedGrid(designed.design, scene.weights, scene.scaling, flat.positions));
    writer.number(scene.design.enforceShrinkage ? scene.design.maxShrinkage : 0);
    writer.points(designed.targets.value_or(Eigen::Matrix3Xd(3, 0)));
  }
  return digestOf(writer.bytes());
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
          {"weights", fmt::format("lateral {}, vertical {}, angle {}", scene.weights.lateral,
                                  scene.weights.vertical, scene.weights.angle)},
          {"scaling", nameOf(scene.scaling)},
          {"method", nameOf(scene.method)},
          {"curvature cutoff", fmt::format("{}", request.curvatureCutoff)},
          {"net", request.net == NetKind::orthogonal ? "orthogonal" : "isoline"},
          {"reference", request.reference == Reference::middle ? "middle" : "convex"},
          {"enforced shrinkage",
           request.enforceShrinkage ? fmt::format("{}", request.maxShrinkage) : "none"},
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
