#include "app/assess_tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "app/disturbed_rest.h"
#include "app/progress_line.h"
#include "core/cancellation.h"
#include "inverse/print_trials.h"
#include "print/print_record.h"

namespace morphgrid {
namespace {

using Eigen::VectorXd;

constexpr int kLevers = 3;

class ToleranceStudy {
 public:
  ToleranceStudy(const Scene& scene, PrintTrials& trials, const DisturbedRest& rest,
                 const PrintPlan& plan, const ToleranceRequest& request, bool quiet)
      : scene_(scene),
        trials_(trials),
        rest_(rest),
        plan_(plan),
        request_(request),
        quiet_(quiet),
        progress_("tolerance", scene.solve.tolerance),
        generator_(request.seed) {
    const int kinds = 3 + (hasPosts() ? 1 : 0) + (hasErrors(plan.material) ? 1 : 0);
    const int levers = kLevers + std::min(kLevers, plan.shape.layers);
    total_ = 2 + kinds * request.samples + 2 * levers;
  }

  void study(PrintTolerance& result) {
    const ShapeError& error = trials_.error();
    result.undisturbed = {error.rmsPercent, error.maxPercent, trials_.equilibrium().converged};
    result.shrinksLess = print(rest_.withAllShrinks(1 - request_.share));
    result.shrinksMore = print(rest_.withAllShrinks(1 + request_.share));
    printAtRandom(result);
    findLevers(result);
  }

 private:
  bool hasPosts() const { return plan_.shape.layers > 1; }

  DisturbedPrint print(const StrutValues& rest) {
    const PrintTrial trial = trials_.tryWith(rest);
    if (scene_.solve.stopRequested()) throw Cancelled();
    ++done_;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!quiet_) {
      progress_.tell(fmt::format("print {} of {}", done_, total_), seconds,
                     done_ > 1 ? seconds / done_ * (total_ - done_) : -1);
    }
    return {trial.error.rmsPercent, trial.error.maxPercent, trial.isConverged, trial.isJump};
  }

  double draw() { return 1 + request_.share * normal_(generator_); }

  template <typename Draw>
  void addKind(PrintTolerance& result, const char* what, const Draw& drawRest) {
    normal_.reset();
    DisturbedPrints kind{.what = what, .prints = {}};
    for (int n = 0; n < request_.samples; ++n) kind.prints.push_back(print(drawRest()));
    result.kinds.push_back(std::move(kind));
  }

  void printAtRandom(PrintTolerance& result) {
    addKind(result, "all struts at once", [&] { return rest_.withAllShrinks(draw()); });
    addKind(result, "each strut", [&] {
      VectorXd factors(rest_.losses().size());
      for (double& factor : factors) factor = draw();
      return rest_.withShrinks(factors);
    });
    addKind(result, "each tier", [&] {
      std::vector<double> tiers(plan_.shape.layers);
      for (double& tier : tiers) tier = draw();
      return rest_.withShrinks(factorsOf([&](const Strut& strut) { return tiers[strut.layer]; }));
    });
    if (hasPosts()) {
      addKind(result, "length of posts", [&] { return rest_.withPosts(draw()); });
    }
    if (hasErrors(plan_.material)) {
      addKind(result, "as the material's errors",
              [&] { return rest_.withMaterial(drawnMaterial(plan_.material, generator_)); });
    }
  }

  template <typename FactorOf>
  VectorXd factorsOf(const FactorOf& factorOf) const {
    VectorXd factors(rest_.losses().size());
    for (Eigen::Index n = 0; n < factors.size(); ++n) {
      factors[n] = factorOf(rest_.struts()[n].strut);
    }
    return factors;
  }

  /// The same struts shrink more, then less, by the share.
  template <typename IsOff>
  ToleranceLever solveLever(std::string what, double firstOrder, const IsOff& isOff) {
    const auto changeWith = [&](double factor) {
      const DisturbedPrint result = print(rest_.withShrinks(
          factorsOf([&](const Strut& strut) { return isOff(strut) ? factor : 1.0; })));
      return result.rmsPercent - trials_.error().rmsPercent;
    };
    const double more = changeWith(1 + request_.share);
    return {std::move(what), firstOrder, more, changeWith(1 - request_.share)};
  }

  void findLevers(PrintTolerance& result) {
    const std::optional<VectorXd> slope = trials_.slope();
    if (!slope) return;
    // Of the distance, when one strut loses that much more.
    const VectorXd changes = -request_.share * slope->cwiseProduct(rest_.losses());
    findTiers(result, changes);
    std::vector<Eigen::Index> order(changes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto middle = order.begin() + std::min<Eigen::Index>(kLevers, changes.size());
    std::partial_sort(order.begin(), middle, order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return std::abs(changes[a]) > std::abs(changes[b]);
    });
    for (auto n = order.begin(); n != middle; ++n) {
      const Strut& strut = rest_.struts()[*n].strut;
      result.struts.push_back(
          solveLever(nameOf(plan_.shape, strut), changes[*n], [&](const Strut& other) {
            return other.from == strut.from && other.direction == strut.direction;
          }));
    }
  }

  void findTiers(PrintTolerance& result, const VectorXd& changes) {
    std::vector<std::pair<double, int>> tiers;
    for (int tier = 0; tier < plan_.shape.layers; ++tier) tiers.emplace_back(0, tier);
    for (Eigen::Index n = 0; n < changes.size(); ++n) {
      tiers[rest_.struts()[n].strut.layer].first += changes[n];
    }
    std::stable_sort(tiers.begin(), tiers.end(), [](const auto& a, const auto& b) {
      return std::abs(a.first) > std::abs(b.first);
    });
    tiers.resize(std::min<std::size_t>(kLevers, tiers.size()));
    for (const auto& [change, tier] : tiers) {
      result.tiers.push_back(
          solveLever(fmt::format("tier {}", tier + 1), change,
                     [tier = tier](const Strut& strut) { return strut.layer == tier; }));
    }
  }

  const Scene& scene_;
  PrintTrials& trials_;
  const DisturbedRest& rest_;
  const PrintPlan& plan_;
  const ToleranceRequest& request_;
  bool quiet_;
  ProgressLine progress_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int done_ = 0;
  int total_ = 0;
};

}  // namespace

PrintTolerance assessTolerance(const Scene& scene, const std::optional<Eigen::Matrix3Xd>& targets,
                               const Stage& designed, const PrintPlan& plan,
                               const ToleranceRequest& request, bool quiet, const Device& device) {
  const Eigen::Matrix3Xd goal =
      targets ? *targets : middleLayer(designed.grid.shape, designed.equilibrium.positions);
  StrutGrid grid = designed.grid;
  grid.rest = plan.rest;
  MultigridSolver solver(device, grid);
  PrintTrials trials(solver, designed.equilibrium, goal, scene.solve);
  if (scene.solve.stopRequested()) throw Cancelled();
  const DisturbedRest rest(designed.grid, plan);
  PrintTolerance result{
      .request = request, .model = nameOf(scene.material.model), .hasTarget = targets.has_value()};
  ToleranceStudy(scene, trials, rest, plan, request, quiet).study(result);
  return result;
}

}  // namespace morphgrid
