#pragma once
#include <Eigen/Core>
#include <vector>

#include "layout/sheet_problem.h"

namespace morphgrid {

/// Where a net's lines run, along u and along v: numbers that ascend, one a vertex.
struct NetLines {
  std::vector<double> u, v;
};
NetLines evenLines(const GridShape& layer);

/// A net of some of another net's lines, evenly spread, its struts as long as those that they stand
/// for.
class CoarseSheetProblem {
 public:
  /// mostJoints: >= 4. Of the finer net it takes every other line, or fewer until they are no more.
  CoarseSheetProblem(const SheetProblem& fine, const NetLines& fineLines, int mostJoints);

  const SheetProblem& problem() const { return problem_; }
  const NetLines& lines() const { return lines_; }

  /// Flat positions of the finer net, 2 x layerVertexCount, by cubic splines through those of the
  /// coarse one.
  Eigen::Matrix2Xd prolong(const Eigen::Matrix2Xd& positions) const;

 private:
  SheetProblem problem_;
  NetLines lines_;
  NetLines fineLines_;
};

}  // namespace morphgrid
