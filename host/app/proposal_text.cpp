#include "app/proposal_text.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <numbers>
#include <sstream>

#include "surface/box_text.h"

namespace morphgrid {
namespace {

std::string quoted(const std::string& text) {
  std::ostringstream stream;
  stream << toml::value<std::string>(text);
  return stream.str();
}

constexpr const char* kTrueShapeText =
    "# Welded bars, as printed grids are, and lengths that bring the simulated grid to its shape,\n"
    "# every strut within the material's range.\n"
    "true_shape = true\n";

double percent(double share) { return 100 * share; }

std::string transformsOf(const Placement& placement) {
  std::string steps;
  const Sight& sight = placement.sight;
  if (sight.degrees != 0) {
    steps += fmt::format(
        "  {{rotate = {{axis = [{}, {}, {}], degrees = {}}}}}, # Rays come along +x: {} of the "
        "file.\n",
        sight.axis.x(), sight.axis.y(), sight.axis.z(), sight.degrees, sight.name);
  }
  const Eigen::Vector3d moved = -placement.center;
  steps += fmt::format("  {{translate = [{}, {}, {}]}}, # The box's middle is the origin.\n",
                       moved.x() + 0.0, moved.y() + 0.0, moved.z() + 0.0);
  steps += fmt::format("  {{scale = {}}}, # One unit of the file becomes {} mm.\n", placement.scale,
                       placement.scale);
  return "transforms = [\n" + steps + "]\n";
}

bool isPrinted(const ProposalRequest& request) { return !request.printerFile.empty(); }

std::string surfaceText(const SceneProposal& proposal,
                        const std::filesystem::path& meshConfiguration) {
  const SceneProposal& p = proposal;
  return fmt::format(
      "[surface]\n"
      "kind = \"mesh\"\n"
      "mesh = {}\n"
      "# The largest box without holes in which the surface is no steeper than {:g} ({:.0f} "
      "degrees)\n"
      "# and a grid can be printed; {:.0f} % of the mesh's area lies in it. Lengths are mm.\n"
      "{}\n"
      "fill_holes = {} # Smaller holes are closed from their rim.\n\n",
      quoted(meshConfiguration.string()), p.slope, std::atan(p.slope) * 180 / std::numbers::pi,
      percent(p.share), boxAsToml(*p.surface.box), p.surface.fillHoles);
}

std::string gridText(const DesignRequest& design, const ProposalRequest& request) {
  const bool isPapers = request.isPapers;
  return fmt::format(
      "[grid]\n"
      "layers = {}\n"
      "layer_spacing = {} # {}\n"
      "nodes_long = {} # Along the longer side; more are finer and slower.\n"
      "{}{}",
      design.layers, design.layerSpacing,
      isPapers ? "As far as Eq. 21 allows, or a third of a strut."
               : "About a third of a strut, less where the surface curves too strongly (Eq. 21).",
      design.nodesLong,
      isPrinted(request) ? ""
                         : fmt::format("max_shrinkage = {} # What the material can lose of its "
                                       "length: PLA about 0.4.\n",
                                       design.maxShrinkage),
      design.curvatureCutoff < 1
          ? fmt::format("curvature_cutoff = {} # Stronger curvature, on creases, neither thins the "
                        "layers nor adds nodes.\n",
                        design.curvatureCutoff)
          : "");
}

std::string netText(const SceneProposal& proposal) {
  const NetKind net = proposal.design.net;
  const char* why = "Lines that cross at right angles: came out better than \"isoline\".";
  if (net == NetKind::isoline) why = "\"orthogonal\" came out no better.";
  if (proposal.request.isPapers) why = "As in the paper.";
  return fmt::format("net = \"{}\" # {}\n", nameOf(net), why);
}

std::string trueDesignText(const SceneProposal& proposal) {
  return fmt::format("{}\n[design]\n{}compensate = {}\noptimise = {}\n",
                     isPrinted(proposal.request)
                         ? ""
                         : fmt::format("\n[material]\nleast_shrinkage = {} # What every strut "
                                       "loses at the least.\n",
                                       proposal.material.leastShrinkage),
                     netText(proposal), proposal.design.compensateRounds,
                     proposal.design.optimiseSteps);
}

std::string printText(const ProposalRequest& request) {
  if (!isPrinted(request)) {
    return "";
  }
  return fmt::format(
      "\n# Every strut keeps to what the material can at its length; bars are as wide and high as "
      "printed.\n"
      "[print]\n"
      "printer = {}\n"
      "material = {}\n"
      "{}scale = 1 # mm of the finished object per unit, mm here; without it the largest that "
      "fits.\n",
      quoted(request.printerFile.string()), quoted(request.materialFile.string()),
      request.size ? "" : "# ");
}

std::string sightLine(const SightRating& rating) {
  return fmt::format("{} {:.0f} %", rating.sight.name, percent(rating.share));
}

}  // namespace

std::string proposalSceneText(const SceneProposal& proposal,
                              const std::filesystem::path& meshConfiguration) {
  const bool isPapers = proposal.request.isPapers;
  return fmt::format(
             "# Proposed by `morphgrid new` for {}; change what you like.\ntitle = {}\n{}\n",
             proposal.request.mesh.filename().string(),
             quoted(proposal.request.mesh.stem().string()), isPapers ? "" : kTrueShapeText) +
         surfaceText(proposal, meshConfiguration) + gridText(proposal.design, proposal.request) +
         (isPapers ? "\n# The paper's model: springs, and lengths by formula.\n[design]\n" +
                         netText(proposal)
                   : trueDesignText(proposal)) +
         printText(proposal.request);
}

std::string proposalMeshText(const SceneProposal& proposal, const std::filesystem::path& mesh) {
  const MeshConfiguration& configuration = proposal.surface.configuration;
  std::string text = fmt::format("mesh = {}\n", quoted(mesh.string()));
  if (configuration.subdivisions > 0) {
    text += fmt::format("subdivisions = {} # Its {} triangles are flat facets: smoothed.\n",
                        configuration.subdivisions, proposal.triangles);
  }
  text += transformsOf(proposal.placement);
  text += fmt::format("samples_u = {}\nsamples_v = {}\n", configuration.samplesU,
                      configuration.samplesV);
  return text;
}

std::string proposalSummary(const SceneProposal& proposal) {
  std::string text =
      fmt::format("seen {}: {:.0f} % of the surface lie in the box, slopes up to {:g}\n",
                  proposal.placement.sight.name, percent(proposal.share), proposal.slope);
  text += "sides, and what of the surface a box shows there:";
  for (const SightRating& rating : proposal.sights) {
    text += (&rating == &proposal.sights.front() ? " " : ", ") + sightLine(rating);
  }
  text += "\n";
  for (const auto& [what, outcome] : proposal.tried) {
    text += fmt::format("  {}: {}\n", what, outcome);
  }
  return text;
}

}  // namespace morphgrid
