// The inverse of a symmetric block of 6 x 6, quarter by quarter.
#include "solve/block.glsl"
#include "solve/symmetric_inverse.glsl"

// A pivot below this share of its diagonal counts as absent: its row and column of the inverse are zero.
// Columns of one layer do not turn; in the plane nothing holds z.
const float kLeastPivot = 1e-5;

Block inverseOf(Block a) {
  mat3 inverseTt = inverseOf(a.tt, kLeastPivot * diagonalOf(a.tt));
  mat3 wtTimesInverse = a.wt * inverseTt;
  mat3 schurComplement = a.ww - wtTimesInverse * transpose(a.wt);
  Block inverse;
  inverse.ww = inverseOf(schurComplement, kLeastPivot * diagonalOf(a.ww));
  inverse.wt = -inverse.ww * wtTimesInverse;
  inverse.tw = transpose(inverse.wt);
  inverse.tt = inverseTt - transpose(wtTimesInverse) * inverse.wt;
  return inverse;
}
