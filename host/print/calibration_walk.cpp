#include "print/calibration_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "print/strut_paths.h"
#include "print/tier_paths.h"
#include "print/tier_tag.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;

class PlateWalk {
 public:
  PlateWalk(const CalibrationPlate& plate, TierVisitor& visitor)
      : plate_(plate), plan_(plate.plan), visitor_(visitor) {}

  void walk() {
    bool isFirst = true;
    for (const PlatePass& pass : passesOf(plate_)) {
      visitor_.beginPass({pass.z, pass.height});
      fastest_ =
          pass.pass == 0 ? plan_.printer.firstPassSpeed : std::numeric_limits<double>::infinity();
      if (isFirst) layStroke(skirtOf(plan_), PathKind::skirt, pass.height);
      isFirst = false;
      for (const Specimen& specimen : plate_.specimens) {
        if (specimen.heightStep == pass.heightStep) layChain(specimen, pass);
      }
    }
    layTubes();
  }

 private:
  Vector2d hubAt(const Specimen& specimen, int n) const {
    return plan_.positions.col(specimen.firstHub + n);
  }

  void layStroke(std::vector<Vector2d> points, PathKind kind, double height) {
    path_ = strokeOf(plan_, std::move(points), kind, height, fastest_);
    visitor_.lay(path_);
  }

  /// There in odd rows, back in even ones.
  void layChain(const Specimen& specimen, const PlatePass& pass) {
    const bool isForward = specimen.number % 2 == 1;
    const int last = specimen.struts;
    if (pass.pass < kTagPasses) {
      for (auto& stroke : numberOf(plate_, specimen)) {
        layStroke(std::move(stroke), PathKind::tag, pass.height);
      }
    }
    const int step = isForward ? 1 : -1;
    int n = isForward ? 0 : last;
    layRings(specimen, n, pass, step);
    for (int count = 0; count < last; ++count, n += step) {
      layStrut(specimen, n, n + step, pass);
      layRings(specimen, n + step, pass, -step);
    }
  }

  void layStrut(const Specimen& specimen, int from, int to, const PlatePass& pass) {
    const double shift = pass.pass % 2 == 0 ? -kZoneShift : kZoneShift;
    path_.place = {std::min(from, to), specimen.number, 0};
    path_.isAlongU = true;
    path_.aroundHub = hubAt(specimen, from);
    visitStrut(plan_,
               {hubAt(specimen, from), hubAt(specimen, to), specimen.shareAlong, pass.height,
                from < to ? shift : -shift, fastest_},
               path_, [&](const PrintPath& path) { visitor_.lay(path); });
    path_.aroundHub.reset();
  }

  /// Begins on the side of the neighbour in direction `towards`.
  void layRings(const Specimen& specimen, int hub, const PlatePass& pass, int towards) {
    if (pass.ringHeight == 0) return;
    const Vector2d side = towards * (hubAt(specimen, 1) - hubAt(specimen, 0));
    layHub(specimen, hub, PathKind::hub, std::atan2(side.y(), side.x()), pass.ringHeight,
           std::min(plan_.material.hub.speed, fastest_));
  }

  void layHub(const Specimen& specimen, int hub, PathKind kind, double angle, double height,
              double speed) {
    path_.place = {hub, specimen.number, 0};
    path_.kind = kind;
    path_.bead = plan_.strutBead(height);
    path_.speed = speed;
    visitRings(plan_, hubAt(specimen, hub), angle, path_,
               [&](const PrintPath& path) { visitor_.lay(path); });
  }

  /// Pass by pass, as far as each goes.
  void layTubes() {
    const PrintMaterial::TubeRings& tube = plan_.material.tube;
    for (int pass = 0; hasTubesAt(pass); ++pass) {
      visitor_.beginPass({plan_.heights.strut + (pass + 1) * tube.passHeight, tube.passHeight});
      for (const Specimen& specimen : plate_.specimens) {
        for (std::size_t hub = 0; hub < specimen.tubes.size(); ++hub) {
          if (reaches(specimen.tubes[hub], pass)) {
            layHub(specimen, static_cast<int>(hub), PathKind::tube, 0, tube.passHeight, tube.speed);
          }
        }
      }
    }
  }

  bool reaches(double tube, int pass) const {
    return tube > (pass + 0.5) * plan_.material.tube.passHeight;
  }

  bool hasTubesAt(int pass) const {
    return std::any_of(plate_.specimens.begin(), plate_.specimens.end(),
                       [&](const Specimen& specimen) {
                         return std::any_of(specimen.tubes.begin(), specimen.tubes.end(),
                                            [&](double tube) { return reaches(tube, pass); });
                       });
  }

  const CalibrationPlate& plate_;
  const PrintPlan& plan_;
  TierVisitor& visitor_;
  PrintPath path_;
  double fastest_ = 0;
};

}  // namespace

std::vector<PlatePass> passesOf(const CalibrationPlate& plate) {
  std::set<double> steps;
  for (const Specimen& specimen : plate.specimens) steps.insert(specimen.heightStep);
  std::vector<PlatePass> passes;
  for (const double step : steps) {
    PrintMaterial material = plate.plan.material;
    material.strut.heightStep = step;
    double z = 0;
    double sinceRing = 0;
    for (int pass = 0; pass < material.strut.passes; ++pass) {
      const double height = material.heightOf(pass);
      z += height;
      sinceRing += height;
      const bool hasRings =
          (pass + 1) % material.hub.every == 0 || pass + 1 == material.strut.passes;
      passes.push_back({pass, step, height, z, hasRings ? sinceRing : 0});
      if (hasRings) sinceRing = 0;
    }
  }
  std::stable_sort(passes.begin(), passes.end(),
                   [](const PlatePass& a, const PlatePass& b) { return a.z < b.z - 1e-9; });
  return passes;
}

void visitCalibration(const CalibrationPlate& plate, TierVisitor& visitor) {
  PlateWalk(plate, visitor).walk();
}

}  // namespace morphgrid
