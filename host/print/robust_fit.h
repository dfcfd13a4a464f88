#pragma once
#include <Eigen/Core>
#include <vector>

namespace morphgrid {

/// A row of A x = b far from what the others say.
struct OutlyingRow {
  Eigen::Index row = 0;
  double expected = 0;  ///< Of b, by the others.
};

/// Rows more than `least` (in b's unit) and more than five times the scatter of the rest away from
/// the x that makes sum |A x - b| least, which a few wrong rows hardly move; the farthest first.
/// a: m x n of full rank, m > n.
std::vector<OutlyingRow> outlyingRows(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                      double least);

}  // namespace morphgrid
