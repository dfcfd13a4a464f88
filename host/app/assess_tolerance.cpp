#include "app/assess_tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/disturbed_rest.h"
#include "app/progress_line.h"
#include "core/cancellation.h"
#include "inverse/print_trials.h"
#include "print/print_record.h"

namespace morphgrid {
namespace {

using Eigen::VectorXd;

constexpr int kLevers = 3;
/// Movements are told within 14 %: enough to see which are largest.
constexpr int kMovementRows = 24;

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
      addKind(result, "material's errors",
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

  /// What linearised positions say of rest lengths that change so.
  struct Forecast {
    double movement;
    std::optional<double> slope;
    double largest;  ///< Change of the distance, when they change so or the other way.
  };
  Forecast forecast(double squaredMovement, std::optional<double> slope) const {
    const double distance = trials_.error().rmsPercent;
    const double side = 2 * distance * std::abs(slope.value_or(0));
    const auto changeBy = [&](double square) {
      return std::abs(std::sqrt(std::max(0.0, distance * distance + square)) - distance);
    };
    return {std::sqrt(squaredMovement), slope,
            std::max(changeBy(squaredMovement + side), changeBy(squaredMovement - side))};
  }

  /// Those that matter most: n in [0, count).
  template <typename ForecastOf, typename Add>
  static void addLargest(int count, const ForecastOf& forecastOf, const Add& add) {
    std::vector<std::pair<Forecast, int>> all;
    for (int n = 0; n < count; ++n) all.emplace_back(forecastOf(n), n);
    const auto middle = all.begin() + std::min(kLevers, count);
    std::partial_sort(all.begin(), middle, all.end(), [](const auto& a, const auto& b) {
      return a.first.largest > b.first.largest;
    });
    for (auto n = all.begin(); n != middle; ++n) add(n->first, n->second);
  }

  /// The same struts shrink more, then less, by the share.
  template <typename IsOff>
  ToleranceLever solveLever(std::string what, const Forecast& forecast, const IsOff& isOff) {
    const auto changeWith = [&](double factor) {
      const DisturbedPrint result = print(rest_.withShrinks(
          factorsOf([&](const Strut& strut) { return isOff(strut) ? factor : 1.0; })));
      return result.rmsPercent - trials_.error().rmsPercent;
    };
    const double more = changeWith(1 + request_.share);
    return {std::move(what), forecast.movement, forecast.slope, more,
            changeWith(1 - request_.share)};
  }

  void findLevers(PrintTolerance& result) {
    const std::optional<VectorXd> slope = trials_.slope();
    const Eigen::MatrixXd movements = trials_.movements(kMovementRows, request_.seed);
    if (scene_.solve.stopRequested()) throw Cancelled();
    // Of rest lengths, when each strut loses that much more.
    const VectorXd changes = -request_.share * rest_.losses();
    addLargest(
        plan_.shape.layers,
        [&](int tier) {
          const VectorXd change = changes.cwiseProduct(
              factorsOf([&](const Strut& strut) { return strut.layer == tier ? 1.0 : 0.0; }));
          return forecast((movements * change).squaredNorm(),
                          slope ? std::optional(slope->dot(change)) : std::nullopt);
        },
        [&](const Forecast& forecast, int tier) {
          result.tiers.push_back(
              solveLever(fmt::format("tier {}", tier + 1), forecast,
                         [&](const Strut& strut) { return strut.layer == tier; }));
        });
    addLargest(
        static_cast<int>(changes.size()),
        [&](int n) {
          return forecast(changes[n] * changes[n] * movements.col(n).squaredNorm(),
                          slope ? std::optional((*slope)[n] * changes[n]) : std::nullopt);
        },
        [&](const Forecast& forecast, int n) {
          const Strut& off = rest_.struts()[n].strut;
          result.struts.push_back(
              solveLever(nameOf(plan_.shape, off), forecast, [&](const Strut& strut) {
                return strut.from == off.from && strut.direction == off.direction;
              }));
        });
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
