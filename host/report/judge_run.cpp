#include "report/judge_run.h"

#include <fmt/format.h>

namespace morphgrid {
namespace {

/// RMS, in percent of the diagonal: farther from its target a result is another shape.
constexpr double kFarFromTarget = 5;

std::string withCount(int count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

class Judge {
 public:
  Judge(const RunRecord& record, const LaidShape* laid) : record_(record), laid_(laid) {}

  PrintVerdict verdict() {
    verdict_.isOfPrint = record_.full.has_value();
    judgeEnd();
    judgeShape();
    judgeWayFromFlat();
    if (verdict_.isOfPrint) {
      judgeStruts();
      judgeTiers();
    }
    if (verdict_.isOfPrint && !record_.print) {
      verdict_.reservation =
          "as far as grid.max_shrinkage and material.least_shrinkage tell: no [print] names a "
          "printer and a material";
    }
    return std::move(verdict_);
  }

 private:
  void add(std::string what, std::string wayOut = "") {
    verdict_.obstacles.push_back({std::move(what), std::move(wayOut)});
  }

  void judgeEnd() {
    if (record_.deviceFailure) {
      add("the device failed");
    }
    if (record_.isInterrupted) {
      add("the run was interrupted", "run it to its end, or go on with its --checkpoint");
    }
    for (const auto* end : {&record_.inPlane, &record_.full}) {
      const std::optional<Equilibrium>& stage = *end;
      if (!stage || stage->reason == StopReason::interrupted) continue;
      const char* name = end == &record_.full ? "full" : "in-plane";
      if (!stage->converged) {
        add(fmt::format("the simulation did not come to rest ({})", toString(stage->reason)),
            "a higher solver.iteration_limit or a looser solver.tolerance");
      } else if (verdictOf(*stage) == Verdict::saddle) {
        add(fmt::format("the {} stage ended at a saddle", name),
            "another grid.layer_spacing or grid.nodes_long");
      }
    }
  }

  void judgeShape() {
    if (const auto& f = record_.feasibility) {
      if (f->cells.inverted + f->cells.collapsed > 0) {
        add(fmt::format("{} inverted and {} collapsed",
                        withCount(f->cells.inverted, "cell is", "cells are"), f->cells.collapsed),
            "more nodes, a larger weights.angle or a smaller grid.curvature_cutoff");
      }
      if (f->selfIntersection.cells > 0) {
        add(fmt::format("{} through others",
                        withCount(f->selfIntersection.cells, "cell passes", "cells pass")),
            "trim the target or bend it less");
      }
      if (f->closeStruts && f->closeStruts->count > 0) {
        add(fmt::format("{} closer to another than it is thick, {:.3g} of {:.3g}",
                        withCount(f->closeStruts->count, "strut comes", "struts come"),
                        f->closeStruts->smallestClearance, f->closeStruts->thickness),
            "thinner struts, fewer nodes or a larger grid.layer_spacing");
      }
    }
    const auto rms = laid_ && laid_->hasTarget ? std::optional(laid_->laidRmsPercent)
                     : record_.distance        ? std::optional(record_.distance->rmsPercent)
                                               : std::nullopt;
    if (rms > kFarFromTarget) {
      add(fmt::format("the result is {:.3g} % (RMS) from its target", *rms),
          "an inverse design, design.compensate and design.optimise, or a surface that curves "
          "less");
    }
  }

  void judgeWayFromFlat() {
    const char* const wayOut = "help it by hand, or another grid.layer_spacing or design.optimise";
    const auto tell = [&](const std::optional<double>& rms) {
      add(rms ? fmt::format("from flat it morphs into another equilibrium, {:.3g} % (RMS) away",
                            *rms)
              : "from flat it morphs into another equilibrium",
          wayOut);
    };
    if (laid_) {
      if (!laid_->isConverged) add("what is laid did not come to rest");
      if (!laid_->endsThereFromFlat) tell(laid_->fromFlatRmsPercent);
    } else if (record_.inverse && record_.inverse->fromFlat) {
      const FromFlat& check = *record_.inverse->fromFlat;
      if (!check.isSettled) {
        add("whether it gets there from flat is not known", wayOut);
      } else if (!check.sameEquilibrium) {
        tell(check.rmsPercent);
      }
    }
  }

  void judgeStruts() {
    if (record_.print) {
      for (const Obstacle& obstacle : record_.print->obstacles) {
        verdict_.obstacles.push_back(obstacle);
      }
      return;
    }
    if (!record_.shrink) return;
    const ShrinkFigures& s = *record_.shrink;
    if (s.strutsOverLimit + s.strutsUnderLeast > 0) {
      add(fmt::format("{} of {} struts are out of range: {} would have to shrink more than they "
                      "can, {} less",
                      s.strutsOverLimit + s.strutsUnderLeast,
                      record_.grid.shape.lateralStrutCount(), s.strutsOverLimit,
                      s.strutsUnderLeast),
          "design.enforce_shrinkage, a lower grid.layer_spacing, or a material of a wider range");
    }
  }

  void judgeTiers() {
    if (record_.bars && record_.bars->height > record_.grid.layerSpacing) {
      add(fmt::format("bars are {:.3g} high but the layers only {:.3g} apart", record_.bars->height,
                      record_.grid.layerSpacing),
          "a lower material.bar_height, fewer print.passes or a larger grid.layer_spacing");
    }
  }

  const RunRecord& record_;
  const LaidShape* laid_;
  PrintVerdict verdict_;
};

}  // namespace

PrintVerdict judgeRun(const RunRecord& record, const LaidShape* laid) {
  return Judge(record, laid).verdict();
}

}  // namespace morphgrid
