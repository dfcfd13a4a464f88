#include "report/symmetry_figures.h"

#include <cmath>

#include "core/intrinsic_diagonal.h"
#include "core/rigid_alignment.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

// Percent: a target that is further from its twin is not symmetric.
constexpr double kSymmetric = 1e-3;

/// Each vertex where its partner's image lies, up to a rigid motion.
Matrix3Xd twinOf(const GridShape& shape, const Matrix3Xd& layer, Symmetry symmetry) {
  Matrix3Xd twin(3, layer.cols());
  forEachVertex(shape.layer(), [&](const GridPlace& place) {
    const int i = symmetry == Symmetry::mirrorAcrossV ? place.i : shape.cellsU() - place.i;
    const int j = symmetry == Symmetry::mirrorAcrossU ? place.j : shape.cellsV() - place.j;
    twin.col(shape.index(place.i, place.j, 0)) = layer.col(shape.index(i, j, 0));
  });
  if (symmetry != Symmetry::halfTurn) {
    twin.row(0) *= -1;
  }
  return twin;
}

double distanceToTwin(const GridShape& shape, const Matrix3Xd& layer, Symmetry symmetry) {
  const Matrix3Xd twin = twinOf(shape, layer, symmetry);
  return (alignRigidly(twin, layer) * twin - layer).norm() / std::sqrt(double(layer.cols()));
}

}  // namespace

std::string toString(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::mirrorAcrossU:
      return "mirror across u";
    case Symmetry::mirrorAcrossV:
      return "mirror across v";
    case Symmetry::halfTurn:
      return "half turn";
  }
  return "unknown";
}

std::optional<SymmetryFigures> computeSymmetry(const GridShape& shape, const Matrix3Xd& targets,
                                               const Matrix3Xd& result) {
  const double percent = 100 / intrinsicDiagonal(targets);
  std::optional<SymmetryFigures> worst;
  for (const Symmetry symmetry :
       {Symmetry::mirrorAcrossU, Symmetry::mirrorAcrossV, Symmetry::halfTurn}) {
    const double ofTarget = percent * distanceToTwin(shape, targets, symmetry);
    if (!(ofTarget < kSymmetric)) continue;
    const double ofResult = percent * distanceToTwin(shape, result, symmetry);
    if (!worst || ofResult > worst->resultPercent) {
      worst = {symmetry, ofTarget, ofResult};
    }
  }
  return worst;
}

}  // namespace morphgrid
