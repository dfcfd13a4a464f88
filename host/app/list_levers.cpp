#include "app/list_levers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "propose/choose_design.h"
#include "propose/coarsen.h"
#include "report/degrees.h"
#include "surface/box_text.h"
#include "surface/load_mesh.h"
#include "surface/main_extent.h"
#include "surface/ray_hits.h"
#include "surface/subdivide_mesh.h"

namespace morphgrid {
namespace {

constexpr double kWorthIt = 0.8;  // A lever that leaves more of what is wrong is not named.
constexpr std::array kGentleSlopes = {2.0, 1.0};  // Of 63 and 45 degrees.
constexpr double kMuchLarger = 1.5;  // Times as large is a box that is worth turning the mesh.
constexpr int kRoundsOffered = 2;
constexpr std::array kSmoothedStruts = {1.0, 2.0, 4.0};  // Widths, of a strut.
constexpr double kMostlyOpen = 0.3;                      // How far an open sheet faces one side.

/// What resists, by geometry, and in words.
struct Resistance {
  double amount = 0;
  std::string inWords;
};

Resistance resistanceOf(const SceneDesign& designed) {
  if (designed.sheet) {
    const SheetFigures& sheet = designed.sheet->figures;
    const double outside = 100.0 * sheet.strutsOutOfRange / std::max(sheet.lateralStruts, 1);
    return {outside + degrees(sheet.meanTwist),
            fmt::format("{:.3g} % of the struts beyond the material's range and {:.1f} degrees of "
                        "twist",
                        outside, degrees(sheet.meanTwist))};
  }
  const double off = degrees(designed.net->quality.meanAngleDeviation);
  return {off, fmt::format("corners {:.1f} degrees off 90 in the mean", off)};
}

/// What a target's curvature leaves of what was asked for.
struct CurvatureRoom {
  CutoffConsequence now;
  bool isAll;  ///< Neither is the layer spacing clamped nor are nodes raised.

  std::string inWords() const {
    return fmt::format("layers {:.3g} apart and takes {:.0f} nodes", now.layerSpacingLimit,
                       now.fewestNodes);
  }
};

CurvatureRoom roomOn(const Target& target, const DesignRequest& request) {
  const CutoffConsequence now = consequenceOf(request.curvatureCutoff, target.survey(), request);
  return {now,
          now.layerSpacingLimit >= request.layerSpacing && now.fewestNodes <= request.nodesLong};
}

/// To two digits.
double rounded(double value) { return std::stod(fmt::format("{:.1e}", value)); }

/// A scene changed in one way, and what that gives where it helps.
class Levers {
 public:
  Levers(const Scene& scene, const SceneDesign& designed)
      : scene_(scene), designed_(designed), now_(resistanceOf(designed)) {}

  std::vector<std::string> list() {
    tryNet();
    tryBox();
    trySubdivision();
    trySmoothing();
    return std::move(notices_);
  }

 private:
  /// A change that leaves much less curvature.
  struct Eased {
    std::string sentence;
    double curvature;  ///< The largest that counts.
    bool isAll;        ///< It leaves all that was asked for.
  };

  const MeshRequest& surface() const { return std::get<MeshRequest>(scene_.surface); }

  /// The lever's design; whether it is one.
  template <typename Design>
  bool attempt(const std::string& change, const Design& design, const std::string& more = "") {
    try {
      const Resistance then = resistanceOf(design());
      if (then.amount >= kWorthIt * now_.amount) return false;
      notices_.push_back(
          fmt::format("{} leaves {}, now {}{}", change, then.inWords, now_.inWords, more));
      return true;
    } catch (const InputError&) {
      return false;  // What cannot be designed helps nobody.
    }
  }

  void tryNet() {
    Scene changed = scene_;
    const bool isIsoline = scene_.design.net == NetKind::isoline;
    changed.design.net = isIsoline ? NetKind::orthogonal : NetKind::isoline;
    if (isIsoline) changed.design.reference = Reference::middle;
    attempt(fmt::format("design.net = \"{}\"", nameOf(changed.design.net)),
            [&] { return designScene(changed, designed_.target); });
  }

  void tryBox() {
    for (const double slope : kGentleSlopes) {
      if (designed_.mesh && designed_.mesh->largestJump > slope && tryBox(slope)) return;
    }
  }

  bool tryBox(double slope) {
    Scene changed = scene_;
    auto& request = std::get<MeshRequest>(changed.surface);
    const TriangleMesh& mesh = designed_.target->meshSampling()->mesh;
    const MeshConfiguration& configuration = request.configuration;
    request.box = suggestBox(MeshRayCaster(mesh), mainExtent(mesh), configuration.samplesU,
                             configuration.samplesV, slope, request.fillHoles);
    return request.box && attempt(
                              fmt::format("a box without slopes beyond {:g}", slope),
                              [&] { return designScene(changed); },
                              fmt::format(" (surface.steepest_slope = {:g} finds it):\n{}", slope,
                                          boxAsToml(*request.box)));
  }

  void trySubdivision() {
    const bool isFaceted = looksFaceted(designed_.target->survey());
    if (surface().configuration.subdivisions > 0 ||
        (!isFaceted && roomOn(*designed_.target, scene_.design).isAll)) {
      return;
    }
    Scene changed = scene_;
    std::get<MeshRequest>(changed.surface).configuration.subdivisions = kRoundsOffered;
    const auto eased =
        tryCurvature(changed, fmt::format("{}subdivisions = {} in its configuration",
                                          isFaceted ? "the mesh is made of flat facets, "
                                                      "whose creases carry all curvature: "
                                                    : "",
                                          kRoundsOffered));
    if (eased) notices_.push_back(eased->sentence);
  }

  /// The narrowest width that leaves what was asked for, or beyond which a wider one gives little.
  void trySmoothing() {
    const SurfaceSurvey& survey = designed_.target->survey();
    if (roomOn(*designed_.target, scene_.design).isAll) return;
    const double strut =
        std::max(survey.longestIsolineU, survey.longestIsolineV) / scene_.design.nodesLong;
    std::optional<Eased> best;
    for (const double struts : kSmoothedStruts) {
      const double width = rounded(struts * strut);
      if (width <= surface().smoothingWidth) continue;
      Scene changed = scene_;
      std::get<MeshRequest>(changed.surface).smoothingWidth = width;
      auto eased = tryCurvature(changed, fmt::format("surface.smoothing_width = {:g}", width));
      if (!eased || (best && eased->curvature >= kWorthIt * best->curvature)) continue;
      best = std::move(eased);
      if (best->isAll) break;
    }
    if (best) notices_.push_back(best->sentence);
  }

  std::optional<Eased> tryCurvature(const Scene& changed, const std::string& change) const {
    try {
      const auto target = loadTarget(changed);
      const CurvatureRoom then = roomOn(*target, scene_.design);
      const CurvatureRoom now = roomOn(*designed_.target, scene_.design);
      const auto strong = [](const Target& of) { return curvatureAtCutoff(of.survey(), 0.95); };
      if (strong(*target) >= kWorthIt * strong(*designed_.target) &&
          then.now.curvatureLimit >= kWorthIt * now.now.curvatureLimit) {
        return std::nullopt;
      }
      return Eased{
          fmt::format("{} leaves {:.3g} of curvature where it is strong (the cutoff 0.95), "
                      "now {:.3g}: it allows {}; now {}",
                      change, strong(*target), strong(*designed_.target), then.inWords(),
                      now.inWords()),
          then.now.curvatureLimit, then.isAll};
    } catch (const InputError&) {
      return std::nullopt;  // Not every mesh can be subdivided.
    }
  }

  const Scene& scene_;
  const SceneDesign& designed_;
  Resistance now_;
  std::vector<std::string> notices_;
};

}  // namespace

std::vector<std::string> listLevers(const Scene& scene, const SceneDesign& designed) {
  if (!std::holds_alternative<MeshRequest>(scene.surface)) return {};
  return Levers(scene, designed).list();
}

MeshSides lookAtMesh(const Scene& scene) {
  const MeshConfiguration& configuration = std::get<MeshRequest>(scene.surface).configuration;
  const TriangleMesh mesh =
      subdivideLoop(loadMesh(configuration.mesh).mesh, configuration.subdivisions).mesh;
  MeshSides sides{coarsened(transformed(configuration.worldFromMesh, mesh)), {}};
  const Cancellation cancellation([&] { return scene.solve.stopRequested(); });
  sides.sights = rateSights(sides.mesh, listSights(sides.mesh), cancellation);
  return sides;
}

std::vector<std::string> adviseOnSides(const std::vector<SightRating>& sights) {
  const SightRating& best = sights.front();
  const auto now = std::ranges::find_if(
      sights, [](const SightRating& rating) { return rating.sight.degrees == 0; });
  if (now == sights.end() || best.share <= kMuchLarger * now->share) return {};
  const Sight& sight = best.sight;
  const bool isSheet = std::abs(best.facing) > kMostlyOpen;
  return {fmt::format(
      "{} a box shows {:.0f} % of the surface, along +x, where rays look, {:.1f} %: end the mesh's "
      "transforms with {{rotate = {{axis = [{}, {}, {}], degrees = {}}}}}{}",
      sight.name, 100 * best.share, 100 * now->share, sight.axis.x(), sight.axis.y(),
      sight.axis.z(), sight.degrees,
      isSheet && std::abs(sight.degrees) == 90
          ? fmt::format(", or from behind with degrees = {}", -sight.degrees)
          : "")};
}

}  // namespace morphgrid
