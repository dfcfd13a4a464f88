#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "layout/sheet_problem.h"

namespace morphgrid {

/// The energy of layConformally(), a sum of squares. Unknowns: (x, y, turn) of one joint after the
/// other, lengths in mean chords of the target.
class SheetEnergy {
 public:
  explicit SheetEnergy(const SheetProblem& problem);

  double meanChord() const { return meanChord_; }
  const std::vector<SheetBar>& bars() const { return bars_; }

  /// How many times as large a sheet should be for its bars' printed lengths to lie around the
  /// middle of what is allowed.
  double enlargement(const Eigen::Matrix2Xd& positions) const;
  /// Of flat positions, 2 x layerVertexCount in the scene's unit, with joints turned as their bars
  /// are in the mean.
  Eigen::VectorXd unknownsAt(const Eigen::Matrix2Xd& positions) const;
  Eigen::Matrix2Xd positionsOf(const Eigen::VectorXd& unknowns) const;

  double evaluate(const Eigen::VectorXd& unknowns) const;

  /// Of 1/2 E: gradient and Gauss-Newton Hessian, the lower half.
  struct Derivatives {
    Eigen::VectorXd gradient;
    Eigen::SparseMatrix<double> hessian;
  };
  Derivatives differentiate(const Eigen::VectorXd& unknowns) const;

 private:
  double meanChord_;
  std::vector<SheetBar> bars_;
  Eigen::Index joints_;
};

}  // namespace morphgrid
