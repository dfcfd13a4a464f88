#include "print/tier_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "print/strut_paths.h"
#include "print/tier_tag.h"

namespace morphgrid {
namespace {

double angleOf(const Eigen::Vector2d& direction) {
  return std::atan2(direction.y(), direction.x());
}

class TierWalk {
 public:
  TierWalk(const PrintPlan& plan, int tier, TierVisitor& visitor)
      : plan_(plan), tier_(tier), visitor_(visitor) {}

  void walk() {
    const int passes = plan_.material.strut.passes;
    for (int pass = 0; pass < passes; ++pass) {
      beginStrutPass(pass);
      if (pass == 0) laySkirt();
      if (pass < kTagPasses) layTag();
      layLinesAlongU();
      layLinesAlongV();
      if (hasRings_) ringHeight_ = 0;
    }
    if (tier_ + 1 < plan_.shape.layers) layTubes();
  }

 private:
  void beginStrutPass(int pass) {
    height_ = plan_.material.heightOf(pass);
    z_ += height_;
    ringHeight_ += height_;
    hasRings_ =
        (pass + 1) % plan_.material.hub.every == 0 || pass + 1 == plan_.material.strut.passes;
    shift_ = pass % 2 == 0 ? -kZoneShift : kZoneShift;
    fastest_ = pass == 0 ? plan_.printer.firstPassSpeed : std::numeric_limits<double>::infinity();
    visitor_.beginPass({z_, height_});
  }

  GridPlace place(int i, int j) const { return {i, j, tier_}; }

  void laySkirt() { layStroke(skirtOf(plan_), PathKind::skirt); }

  void layTag() {
    for (auto& stroke : tagOf(plan_, tier_)) layStroke(std::move(stroke), PathKind::tag);
  }

  void layStroke(std::vector<Eigen::Vector2d> points, PathKind kind) {
    path_ = strokeOf(plan_, std::move(points), kind, height_, fastest_);
    visitor_.lay(path_);
  }

  void layLinesAlongU() {
    const int last = plan_.shape.verticesU - 1;
    for (int j = 0; j <= plan_.shape.cellsV(); ++j) {
      const int step = j % 2 == 0 ? 1 : -1;
      int i = j % 2 == 0 ? 0 : last;
      layRings(place(i, j), place(i + step, j));
      for (int n = 0; n < last; ++n, i += step) {
        layStrut(place(i, j), place(i + step, j));
        layRings(place(i + step, j), place(i, j));
      }
    }
  }

  void layLinesAlongV() {
    const int last = plan_.shape.verticesV - 1;
    for (int n = 0; n < plan_.shape.verticesU; ++n) {
      // The last line along u ended at one end of the last row.
      const int i = plan_.shape.verticesV % 2 == 1 ? plan_.shape.verticesU - 1 - n : n;
      const int step = n % 2 == 0 ? -1 : 1;
      int j = n % 2 == 0 ? last : 0;
      for (int m = 0; m < last; ++m, j += step) layStrut(place(i, j), place(i, j + step));
    }
  }

  void layStrut(const GridPlace& from, const GridPlace& to) {
    const bool isForward = from.i < to.i || from.j < to.j;
    path_.place = isForward ? from : to;
    path_.isAlongU = from.j == to.j;
    path_.aroundHub = plan_.at(from);
    const int index = plan_.shape.index(path_.place);
    const double share = path_.isAlongU ? plan_.shareAlong.u[index] : plan_.shareAlong.v[index];
    visitStrut(
        plan_,
        {plan_.at(from), plan_.at(to), share, height_, isForward ? shift_ : -shift_, fastest_},
        path_, [&](const PrintPath& path) { visitor_.lay(path); });
    path_.aroundHub.reset();
  }

  /// Begins on the side of the neighbour that the nozzle comes from, or goes to.
  void layRings(const GridPlace& hub, const GridPlace& neighbour) {
    if (!hasRings_) return;
    layHub(hub, angleOf(plan_.at(neighbour) - plan_.at(hub)), PathKind::hub, ringHeight_,
           std::min(plan_.material.hub.speed, fastest_));
  }

  void layHub(const GridPlace& hub, double angle, PathKind kind, double height, double speed) {
    path_.place = hub;
    path_.kind = kind;
    path_.bead = plan_.strutBead(height);
    path_.speed = speed;
    visitRings(plan_, plan_.at(hub), angle, path_,
               [&](const PrintPath& path) { visitor_.lay(path); });
  }

  void layTubes() {
    const bool isLow = plan_.heights.tube <= plan_.printer.nozzleClearance;
    const int rows = plan_.shape.verticesV;
    if (!isLow) {
      layTubes(0, rows);
      return;
    }
    for (int j = 0; j < rows; ++j) layTubes(j, j + 1);
  }

  /// Of rows begin ... end - 1, pass by pass, there and back.
  void layTubes(int begin, int end) {
    const double height = plan_.heights.tube;
    const int passes =
        std::max({1, static_cast<int>(std::lround(height / plan_.material.tube.passHeight)),
                  static_cast<int>(std::ceil(height / plan_.printer.largestHeight))});
    std::vector<GridPlace> hubs;
    for (int j = begin; j < end; ++j) {
      for (int n = 0; n < plan_.shape.verticesU; ++n) {
        hubs.push_back(place(j % 2 == 0 ? n : plan_.shape.verticesU - 1 - n, j));
      }
    }
    for (int pass = 0; pass < passes; ++pass) {
      visitor_.beginPass({z_ + (pass + 1) * height / passes, height / passes});
      for (const GridPlace& hub : hubs) {
        layHub(hub, 0, PathKind::tube, height / passes, plan_.material.tube.speed);
      }
      std::reverse(hubs.begin(), hubs.end());
    }
  }

  const PrintPlan& plan_;
  int tier_;
  TierVisitor& visitor_;
  PrintPath path_;
  double z_ = 0;
  double height_ = 0;
  double ringHeight_ = 0;  ///< Since the last ring.
  bool hasRings_ = false;
  double shift_ = 0;
  double fastest_ = 0;
};

}  // namespace

std::vector<Eigen::Vector2d> skirtOf(const PrintPlan& plan) {
  constexpr double kTurn = std::numbers::pi / 12;  // Round the corners in such steps.
  const double distance = plan.hub.diameter / 2 + kSkirtGap;
  const Eigen::Matrix2Xd outline = convexOutline(plan.positions);
  std::vector<Eigen::Vector2d> skirt;
  for (Eigen::Index n = 0; n < outline.cols(); ++n) {
    const Eigen::Vector2d corner = outline.col(n);
    const Eigen::Vector2d in = corner - outline.col((n + outline.cols() - 1) % outline.cols());
    const Eigen::Vector2d out = outline.col((n + 1) % outline.cols()) - corner;
    const double begin = angleOf(in) - std::numbers::pi / 2;
    double sweep = angleOf(out) - angleOf(in);
    if (sweep < 0) sweep += 2 * std::numbers::pi;
    const int steps = std::max(1, static_cast<int>(std::ceil(sweep / kTurn)));
    for (int step = 0; step <= steps; ++step) {
      const double angle = begin + sweep * step / steps;
      skirt.push_back(corner + distance * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  skirt.push_back(skirt.front());
  return skirt;
}

void visitTier(const PrintPlan& plan, int tier, TierVisitor& visitor) {
  TierWalk(plan, tier, visitor).walk();
}

}  // namespace morphgrid
