// D^-1: the inverses of the blocks of 6 x 6 on a coarse level's diagonal, by L D L^T without pivoting.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block.glsl"

layout(local_size_x_id = 0) in;

layout(binding = kBindingMatrix + 0u, rgba32f) readonly uniform imageBuffer self0;
layout(binding = kBindingMatrix + 1u, rgba32f) readonly uniform imageBuffer self1;
layout(binding = kBindingMatrix + 2u, rgba32f) readonly uniform imageBuffer self2;
layout(std430, binding = kBindingInverse + 0u) writeonly buffer Inverse0 { vec4 inverse0[]; };
layout(std430, binding = kBindingInverse + 1u) writeonly buffer Inverse1 { vec4 inverse1[]; };
layout(std430, binding = kBindingInverse + 2u) writeonly buffer Inverse2 { vec4 inverse2[]; };
layout(push_constant) uniform Push { SmoothingPush push; };

// A pivot below this share of its diagonal counts as absent: its row and column of the inverse are zero.
// Columns of one layer do not turn; in the plane nothing holds z.
const float kLeastPivot = 1e-5;

#define FOR(n) [[unroll]] for (int n = 0; n < 6; ++n)

// The block's lower left half.
float elementOf(Block a, int row, int column) {
  if (row < 3) {
    return a.tt[column][row];
  }
  return column < 3 ? a.wt[column][row - 3] : a.ww[column - 3][row - 3];
}

float lower[6][6];     // L
float inversePivot[6];

void factorise(Block a) {
  float scaled[6][6];  // L D
  FOR(row) {
    float diagonal = elementOf(a, row, row);
    float pivot = diagonal;
    FOR(column) {
      if (column < row) {
        float element = elementOf(a, row, column);
        FOR(n) {
          if (n < column) {
            element -= scaled[row][n] * lower[column][n];
          }
        }
        scaled[row][column] = element;
        lower[row][column] = element * inversePivot[column];
        pivot -= element * lower[row][column];
      }
    }
    inversePivot[row] = pivot > kLeastPivot * diagonal ? 1.0 / pivot : 0.0;
  }
}

// Becomes its own inverse.
void invertLower() {
  FOR(row) {
    FOR(column) {
      if (column < row) {
        float element = -lower[row][column];
        FOR(n) {
          if (n > column && n < row) {
            element -= lower[row][n] * lower[n][column];
          }
        }
        lower[row][column] = element;
      }
    }
    lower[row][row] = 1.0;
  }
}

float inverseElement(int row, int column) {
  float element = 0.0;
  FOR(n) {
    if (n >= row && n >= column) {
      element += inversePivot[n] * lower[n][row] * lower[n][column];
    }
  }
  return element;
}

mat3 inverseQuarter(int row, int column) {
  mat3 quarter;
  [[unroll]] for (int c = 0; c < 3; ++c) {
    [[unroll]] for (int r = 0; r < 3; ++r) { quarter[c][r] = inverseElement(row + r, column + c); }
  }
  return quarter;
}

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= push.pointsU) {
    return;
  }
  int point = p.y * push.pointsU + p.x;
  factorise(BLOCK_AT(self0, self1, self2, point));
  invertLower();
  Block inverse;
  inverse.tt = inverseQuarter(0, 0);
  inverse.tw = inverseQuarter(0, 3);
  inverse.wt = transpose(inverse.tw);
  inverse.ww = inverseQuarter(3, 3);
  STORE_BLOCK(inverse0, inverse1, inverse2, point, inverse);
}
