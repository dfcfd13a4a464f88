#include "propose/propose_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/decimals.h"
#include "core/error.h"
#include "propose/choose_design.h"
#include "surface/box_text.h"
#include "surface/load_mesh.h"
#include "surface/main_extent.h"
#include "surface/ray_hits.h"
#include "surface/subdivide_mesh.h"
#include "target/mesh_target.h"

namespace morphgrid {
namespace {

constexpr std::size_t kMostSights = 4;
constexpr std::array kSlopes = {20.0, 10.0, 6.0, 3.0, 1.7, 1.0, 0.6, 0.35};  // Of 87 to 19 degrees.
constexpr std::array kNets = {NetKind::isoline, NetKind::orthogonal};
constexpr double kFilledHole = 0.03;   // Of the box's longer side.
constexpr double kFewOutOfRange = 0.03;  // Of the struts; inverse design finds lengths for them.
constexpr double kMostTwist = 6;         // Degrees, in the mean.
constexpr int kSmoothTriangles = 10'000;  // Facets of a mesh of so many are small beside the struts.
constexpr int kMostRounds = 3;

double roundedToDigits(double value, int digits) {
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - digits + 1);
  return roundedTo(value, decimalsFor(step));
}

/// A box to design in, and the best design there.
struct Candidate {
  SightRating rating;
  int subdivisions = 0;
  bool isFaceted = false;
  double slope = 0;
  double share = 0;
  MeshRequest surface;
  std::shared_ptr<const Target> target;
  DesignRequest design;
  DesignTrial trial;
};

bool isGood(const DesignTrial& trial) {
  const SheetFigures& sheet = trial.sheet;
  return trial.failure.empty() &&
         sheet.strutsOutOfRange <= kFewOutOfRange * sheet.lateralStruts &&
         sheet.meanTwist * 180 / std::numbers::pi <= kMostTwist;
}

/// The less, the better.
double badness(const DesignTrial& trial) {
  if (!trial.failure.empty()) return std::numeric_limits<double>::infinity();
  const SheetFigures& sheet = trial.sheet;
  const double outside = sheet.lateralStruts > 0
                             ? static_cast<double>(sheet.strutsOutOfRange) / sheet.lateralStruts
                             : trial.net.meanAngleDeviation;  // What springs resist.
  return outside + 0.1 * sheet.meanTwist;
}

std::string inWords(const DesignTrial& trial) {
  if (!trial.failure.empty()) return trial.failure;
  const SheetFigures& sheet = trial.sheet;
  if (sheet.lateralStruts == 0) {
    return fmt::format("corners off 90 degrees by {:.1f} in the mean",
                       trial.net.meanAngleDeviation * 180 / std::numbers::pi);
  }
  return fmt::format("{:.1f} % of the struts beyond what the material allows, twist {:.1f} degrees",
                     100.0 * sheet.strutsOutOfRange / sheet.lateralStruts,
                     sheet.meanTwist * 180 / std::numbers::pi);
}

class Proposer {
 public:
  Proposer(const ProposalRequest& request, const TryDesign& tryDesign, const ProposalWatch& watch)
      : request_(request),
        tryDesign_(tryDesign),
        watch_(watch),
        mesh_(loadMesh(request.mesh)),
        meshArea_(areaOf(mesh_)) {}

  SceneProposal propose() {
    tell("looking at it from all sides");
    sights_ = rateSights(mesh_, listSights(mesh_), watch_.cancellation);
    std::size_t looked = 0;
    for (const SightRating& rating : sights_) {
      if (!rating.box || looked == kMostSights || rating.share < shareToBeat()) break;
      if (seesWhatWasSeen(rating)) continue;
      ++looked;
      searchAlong(rating);
    }
    if (good_) return finish(*good_);
    if (best_) return finish(*best_);
    throw InputError(fmt::format("{}: {}", request_.mesh.string(), whyNot()));
  }

 private:
  void tell(const std::string& what) const {
    watch_.cancellation.check();
    if (watch_.onProgress) watch_.onProgress(what);
  }

  /// From behind, an open sheet looks as from the front.
  bool seesWhatWasSeen(const SightRating& rating) const {
    const SightRating& first = sights_.front();
    return &rating != &first && std::abs(first.facing) > 0.3 &&
           rating.sight.direction().dot(first.sight.direction()) < -0.99;
  }

  std::string whyNot() const {
    if (tried_.empty()) {
      return "no side of the mesh shows a piece without holes that is large enough for rays; "
             "surface.fill_holes of a scene closes larger ones";
    }
    std::vector<std::string> lines = {"no design was possible; tried were"};
    for (const auto& [what, outcome] : tried_) lines.push_back(fmt::format("  {}: {}", what, outcome));
    return fmt::format("{}", fmt::join(lines, "\n"));
  }

  double shareToBeat() const { return good_ ? good_->share : 0; }

  /// Looks for a design that is good in a larger box than that of another side; slopes become
  /// gentler, and boxes smaller.
  void searchAlong(const SightRating& rating) {
    Candidate candidate{.rating = rating};
    auto placed = place(candidate);
    double lastShare = std::numeric_limits<double>::infinity();
    for (const double slope : kSlopes) {
      candidate.slope = slope;
      if (!chooseBox(candidate, *placed)) continue;
      if (candidate.share <= shareToBeat()) return;
      if (candidate.share > 0.99 * lastShare) continue;  // The same box again.
      lastShare = candidate.share;
      if (!survey(candidate, placed)) continue;
      if (candidate.subdivisions == 0 && looksFaceted(candidate.target->survey()) &&
          smooth(candidate, placed) && !survey(candidate, placed)) {
        continue;
      }
      chooseNet(candidate);
      if (isGood(candidate.trial)) {
        good_ = candidate;
        return;
      }
      remember(candidate);
    }
  }

  std::shared_ptr<const PlacedMesh> place(Candidate& candidate) const {
    MeshConfiguration configuration{.mesh = request_.mesh, .subdivisions = candidate.subdivisions};
    configuration.worldFromMesh = Eigen::Affine3d(candidate.rating.sight.rotation());
    candidate.surface.configuration = configuration;
    return placeMesh(mesh_, configuration);
  }

  /// Subdivides where that can be done, and looks for the box anew.
  bool smooth(Candidate& candidate, std::shared_ptr<const PlacedMesh>& placed) const {
    if (mesh_.triangles.cols() >= kSmoothTriangles) return false;
    Candidate smoother = candidate;
    smoother.isFaceted = true;
    while (smoother.subdivisions < kMostRounds &&
           mesh_.triangles.cols() << (2 * smoother.subdivisions) < kSmoothTriangles) {
      ++smoother.subdivisions;
    }
    try {
      const auto smoothed = place(smoother);
      if (!chooseBox(smoother, *smoothed)) return false;
      placed = smoothed;
      candidate = smoother;
      return true;
    } catch (const InputError&) {
      return false;  // Edges of three triangles, or one side only: it stays as it is.
    }
  }

  bool chooseBox(Candidate& candidate, const PlacedMesh& placed) const {
    tell(fmt::format("a box {}, slopes up to {:g}", candidate.rating.sight.name, candidate.slope));
    const MeshConfiguration& configuration = candidate.surface.configuration;
    const Eigen::AlignedBox3d extent = mainExtent(placed.mesh);
    const double widest = extent.sizes().tail<2>().maxCoeff();
    candidate.surface.box =
        suggestBox(placed.caster, extent, configuration.samplesU, configuration.samplesV,
                   candidate.slope, kFilledHole * widest);
    if (!candidate.surface.box) return false;
    const SamplingBox& box = *candidate.surface.box;
    candidate.surface.fillHoles = kFilledHole * widest;
    RayHits hits = placed.caster.cast(box, configuration.samplesU, configuration.samplesV);
    fillHoles(hits, candidate.surface.fillHoles);
    candidate.share = areaBetween(hits) / meshArea_;
    return true;
  }

  bool survey(Candidate& candidate, const std::shared_ptr<const PlacedMesh>& placed) {
    try {
      candidate.target = makeMeshTarget(placed, candidate.surface, watch_.cancellation);
      return true;
    } catch (const InputError& error) {
      tried_.push_back({inWords(candidate), error.what()});
      return false;
    }
  }

  void chooseNet(Candidate& candidate) {
    std::optional<Candidate> best;
    for (const NetKind net : kNets) {
      if (request_.isPapers && net != NetKind::isoline) continue;
      Candidate other = candidate;
      designOn(other, net);
      if (!best || badness(other.trial) < badness(best->trial)) best = other;
    }
    candidate = *best;
  }

  /// Layers closer to each other where the first ones do not fit.
  void designOn(Candidate& candidate, NetKind net) {
    candidate.design = chooseDesign(candidate.target->survey(), request_, net);
    tryOut(candidate);
    if (!isGood(candidate.trial) && candidate.trial.failure.empty() && !request_.isPapers) {
      const auto spacing =
          fittingSpacing(candidate.trial, candidate.target->survey(), candidate.design);
      if (spacing) {
        candidate.design.layerSpacing = *spacing;
        tryOut(candidate);
      }
    }
  }

  void tryOut(Candidate& candidate) {
    candidate.design.layerSpacing = roundedToDigits(candidate.design.layerSpacing, 3);
    tell(fmt::format("trying {}", inWords(candidate)));
    candidate.trial = tryDesign_(candidate.surface, candidate.target, candidate.design,
                                 chooseMaterial(request_));
    tried_.push_back({inWords(candidate), morphgrid::inWords(candidate.trial)});
  }

  std::string inWords(const Candidate& candidate) const {
    return fmt::format("{}, slopes up to {:g}, {} net, {:.0f} % of the surface",
                       candidate.rating.sight.name, candidate.slope, nameOf(candidate.design.net),
                       100 * candidate.share);
  }

  void remember(const Candidate& candidate) {
    if (candidate.trial.failure.empty() &&
        (!best_ || badness(candidate.trial) < badness(best_->trial))) {
      best_ = candidate;
    }
  }

  /// Moves and scales it all, and sees whether it still holds.
  SceneProposal finish(const Candidate& candidate) {
    SceneProposal proposal{.request = request_,
                           .surface = candidate.surface,
                           .design = candidate.design,
                           .material = chooseMaterial(request_),
                           .share = candidate.share,
                           .slope = candidate.slope,
                           .mesh = mesh_,
                           .seen = *candidate.surface.box,
                           .isFaceted = candidate.isFaceted,
                           .trial = candidate.trial,
                           .sights = sights_,
                           .tried = tried_};
    const SamplingBox& box = *candidate.surface.box;
    Placement& placement = proposal.placement;
    placement = {.sight = candidate.rating.sight};
    const double longer = std::max(box.uLength, box.vLength);
    const int decimals = decimalsFor(1e-3 * longer);
    const auto place = [&](double value) { return roundedTo(value, decimals); };
    placement.scale = roundedToDigits(request_.size / longer, 4);
    const auto& points = candidate.target->meshSampling()->hits.points;
    placement.center << place((points.row(0).minCoeff() + points.row(0).maxCoeff()) / 2),
        place(box.uStart + box.uLength / 2), place(box.vStart + box.vLength / 2);

    const double scale = placement.scale;
    proposal.surface.configuration.worldFromMesh = placement.worldFromMesh();
    proposal.surface.box =
        roundedBox({scale * (box.uStart - placement.center.y()),
                    scale * (box.vStart - placement.center.z()), scale * box.uLength,
                    scale * box.vLength});
    proposal.surface.fillHoles = roundedToDigits(scale * candidate.surface.fillHoles, 2);
    proposal.design.layerSpacing = roundedToDigits(scale * candidate.design.layerSpacing, 3);
    verify(proposal);
    return proposal;
  }

  /// Rounded numbers are others.
  void verify(SceneProposal& proposal) const {
    tell("verifying");
    const auto placed = placeMesh(mesh_, proposal.surface.configuration);
    const auto target = makeMeshTarget(placed, proposal.surface, watch_.cancellation);
    proposal.trial = tryDesign_(proposal.surface, target, proposal.design, proposal.material);
    if (!proposal.trial.failure.empty()) {
      throw InputError(fmt::format("{}: {}", request_.mesh.string(), proposal.trial.failure));
    }
  }

  const ProposalRequest& request_;
  const TryDesign& tryDesign_;
  const ProposalWatch& watch_;
  TriangleMesh mesh_;
  double meshArea_;
  std::vector<SightRating> sights_;
  std::vector<TriedCandidate> tried_;
  std::optional<Candidate> good_;  ///< Of those that are good, the one that shows the most.
  std::optional<Candidate> best_;  ///< Of the others, the least bad.
};

/// As a mesh configuration's steps do it, one after the other.
Eigen::Affine3d asStep(const Eigen::Matrix3d& linear, const Eigen::Vector3d& translation) {
  Eigen::Affine3d step = Eigen::Affine3d::Identity();
  step.linear() = linear;
  step.translation() = translation;
  return step;
}

}  // namespace

Eigen::Affine3d Placement::worldFromMesh() const {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return asStep(scale * identity, zero) *
         (asStep(identity, -center) * asStep(sight.rotation(), zero));
}

SceneProposal proposeScene(const ProposalRequest& request, const TryDesign& tryDesign,
                           const ProposalWatch& watch) {
  return Proposer(request, tryDesign, watch).propose();
}

}  // namespace morphgrid
