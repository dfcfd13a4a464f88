#include "propose/propose_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/decimals.h"
#include "core/error.h"
#include "propose/candidate.h"
#include "propose/choose_design.h"
#include "propose/coarsen.h"
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
constexpr double kFilledHole = 0.06;  // Of the mesh's longer side, as rays see it.
constexpr int kSmoothTriangles =
    10'000;  // Facets of a mesh of so many are small beside the struts.
constexpr int kMostRounds = 3;

class Proposer {
 public:
  Proposer(const ProposalRequest& request, const TryDesign& tryDesign, const ProposalWatch& watch)
      : request_(request),
        tryDesign_(tryDesign),
        watch_(watch),
        loaded_(loadMesh(request.mesh)),
        meshArea_(surfaceArea(loaded_.mesh)) {}

  SceneProposal propose() {
    tell("looking at it from all sides");
    look_ = coarsened(loaded_.mesh);
    sights_ = rateSights(look_, listSights(look_), watch_.cancellation);
    std::size_t looked = 0;
    for (const SightRating& rating : sights_) {
      if (!rating.box || looked == kMostSights || rating.share < shareToBeat()) break;
      if (seesWhatWasSeen(rating)) continue;
      ++looked;
      searchAlong(rating);
    }
    for (const std::optional<Candidate>* candidate : {&good_, &best_}) {
      if (!*candidate) continue;
      if (auto proposal = finish(**candidate)) return std::move(*proposal);
    }
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
    for (const auto& [what, outcome] : tried_)
      lines.push_back(fmt::format("  {}: {}", what, outcome));
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
    return placeMesh(loaded_, configuration);
  }

  /// Subdivides where that can be done, and looks for the box anew.
  bool smooth(Candidate& candidate, std::shared_ptr<const PlacedMesh>& placed) const {
    if (loaded_.mesh.triangles.cols() >= kSmoothTriangles) return false;
    Candidate smoother = candidate;
    while (smoother.subdivisions < kMostRounds &&
           loaded_.mesh.triangles.cols() << (2 * smoother.subdivisions) < kSmoothTriangles) {
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
    const Eigen::AlignedBox3d& extent = placed.extent;
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
      tried_.push_back({describe(candidate), error.what()});
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
    tell(fmt::format("trying {}", describe(candidate)));
    candidate.trial =
        tryDesign_(candidate.surface, candidate.target, candidate.design, chooseMaterial(request_));
    tried_.push_back({describe(candidate), describe(candidate.trial)});
  }

  void remember(const Candidate& candidate) {
    if (candidate.trial.failure.empty() &&
        (!best_ || badness(candidate.trial) < badness(best_->trial))) {
      best_ = candidate;
    }
  }

  /// Moves and scales it all, and sees whether it still holds: rounded numbers are others.
  std::optional<SceneProposal> finish(const Candidate& candidate) {
    tell("verifying");
    SceneProposal proposal = settle(candidate, request_);
    try {
      const auto placed = placeMesh(loaded_, proposal.surface.configuration);
      const auto target = makeMeshTarget(placed, proposal.surface, watch_.cancellation);
      proposal.trial = tryDesign_(proposal.surface, target, proposal.design, proposal.material);
    } catch (const InputError& error) {
      proposal.trial.failure = error.what();
    }
    if (!proposal.trial.failure.empty()) {
      tried_.push_back({describe(candidate) + ", scaled", proposal.trial.failure});
      return std::nullopt;
    }
    proposal.look = std::move(look_);
    proposal.triangles = static_cast<int>(loaded_.mesh.triangles.cols());
    proposal.sights = sights_;
    proposal.tried = tried_;
    return proposal;
  }

  const ProposalRequest& request_;
  const TryDesign& tryDesign_;
  const ProposalWatch& watch_;
  NotedMesh loaded_;
  TriangleMesh look_;
  double meshArea_;
  std::vector<SightRating> sights_;
  std::vector<TriedCandidate> tried_;
  std::optional<Candidate> good_;  ///< Of those that are good, the one that shows the most.
  std::optional<Candidate> best_;  ///< Of the others, the least bad.
};

}  // namespace

SceneProposal proposeScene(const ProposalRequest& request, const TryDesign& tryDesign,
                           const ProposalWatch& watch) {
  return Proposer(request, tryDesign, watch).propose();
}

}  // namespace morphgrid
