#include "app/scene_settings.h"

#include <limits>

namespace morphgrid {
namespace {

// Far beyond what a grid that converges needs: tens of cycles, thousands of simple iterations.
constexpr long kCycleLimit = 5000;

}  // namespace

Weights readWeights(TomlReader& reader) {
  TomlSection section = reader.section("weights");
  Weights weights;
  weights.lateral = section.number("lateral", above(0)).value_or(weights.lateral);
  weights.vertical = section.number("vertical", above(0)).value_or(weights.vertical);
  weights.angle = section.number("angle", atLeast(0)).value_or(weights.angle);
  return weights;
}

SolverSettings readSolverSettings(TomlReader& reader) {
  TomlSection section = reader.section("solver");
  SolverSettings solver;
  solver.method = section
                      .choice<Method>("method", {{"multigrid", Method::multigrid},
                                                 {"jacobi", Method::jacobi},
                                                 {"reference", Method::reference}})
                      .value_or(solver.method);
  solver.scaling = section
                       .choice<Scaling>("scaling", {{"normalised", Scaling::normalised},
                                                    {"shapeop", Scaling::shapeop}})
                       .value_or(solver.scaling);
  SolveOptions& options = solver.options;
  options.tolerance = section.number("tolerance", between(0, 1)).value_or(options.tolerance);
  const bool multigrid = solver.method == Method::multigrid;
  options.energyTolerance =
      section.number("energy_tolerance", NumberRange{.low = 0, .high = 1, .lowIncluded = true})
          .value_or(options.energyTolerance);
  options.iterationLimit = section.integer("iteration_limit", {.low = 0})
                               .value_or(multigrid ? kCycleLimit : options.iterationLimit);
  solver.smallestEigenvalue =
      section.boolean("smallest_eigenvalue").value_or(solver.smallestEigenvalue);
  return solver;
}

OutputChoices readOutputChoices(TomlReader& reader) {
  TomlSection section = reader.section("output");
  constexpr IntegerRange kPixels{64, 8192};
  OutputChoices output;
  PictureChoices& pictures = output.pictures;
  pictures.enabled = section.boolean("pictures").value_or(pictures.enabled);
  pictures.width = static_cast<int>(section.integer("width", kPixels).value_or(pictures.width));
  pictures.height = static_cast<int>(section.integer("height", kPixels).value_or(pictures.height));
  FileChoices& files = output.files;
  files.gltf = section.boolean("gltf").value_or(files.gltf);
  files.vtu = section.boolean("vtu").value_or(files.vtu);
  files.ply = section.boolean("ply").value_or(files.ply);
  files.obj = section.boolean("obj").value_or(files.obj);
  files.state = section.boolean("state").value_or(files.state);
  return output;
}

std::optional<PublishedFigures> readPublishedFigures(TomlReader& reader) {
  TomlSection section = reader.section("paper");
  const IntegerRange count{1, std::numeric_limits<int>::max()};
  PublishedFigures figures;
  figures.figure = section.text("figure").value_or("");
  figures.longestIsolineU = section.number("longest_isoline_u", above(0));
  figures.longestIsolineV = section.number("longest_isoline_v", above(0));
  figures.largestCurvature = section.number("largest_curvature", atLeast(0));
  figures.nodesU = section.integer("nodes_u", count);
  figures.nodesV = section.integer("nodes_v", count);
  figures.bendShrinkPercent = section.number("bend_shrink_percent", atLeast(0));
  figures.l0Percent = section.number("l0_percent", atLeast(0));
  figures.lbPercent = section.number("lb_percent", atLeast(0));
  figures.anglePercent = section.number("angle_percent", atLeast(0));
  return section.present() ? std::optional(figures) : std::nullopt;
}

}  // namespace morphgrid
