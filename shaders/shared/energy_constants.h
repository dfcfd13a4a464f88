// Compiles as GLSL and as C++: what keeps the energy and its derivatives finite in single
// precision. Lengths are in spacings.
#ifndef MORPHGRID_ENERGY_CONSTANTS_H
#define MORPHGRID_ENERGY_CONSTANTS_H
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// Where it divides, an edge's |e|^2 counts as no less than this: a missing edge is the zero vector.
// Edges below 1e-5 spacings have no direction in single precision anyway. The inverse of its cube
// is still a float, with room for angle weights of 1e7.
CONSTANT float kLeastSquare = 1e-10f;

// Added to R^2 = t^2 - s^2 of a corner (energy/corner.glsl), which is 0 where its edges are
// collinear or missing; far below the rounding of t^2 elsewhere.
CONSTANT float kLeastDiscriminant = 1e-14f;

// Where edges are collinear a corner's residual has no derivative: its Hessians add the square of
// this share of t to R^2, and where it divides by A (energy/corner.glsl), that is no less than this
// share of t.
CONSTANT float kLeastSine = 1e-3f;
CONSTANT float kLeastSine2 = 1e-6f;  // Its square.

#ifdef __cplusplus
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
