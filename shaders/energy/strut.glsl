// The strut term: energy c (|e| - L)^2, with n = e / |e| and the relative stretch k = 1 - L / |e|.
#ifndef MORPHGRID_ENERGY_STRUT
#define MORPHGRID_ENERGY_STRUT
#include "energy/derivative.glsl"
#include "energy/edge.glsl"

struct Spring {
  int rest;              // L in steps of the fixed point
  float restResolution;  // Spacings per step.
  float stiffness;       // c
};

// With respect to the edge: diagonal.x e + diagonal.y e', e' its change; for products with a Hessian this
// is how the gradient changes.
struct StrutGradient {
  vec2 diagonal;
  Squared energy;
};

// The second derivatives: outer e e^T + identity I.
struct StrutHessian {
  float outer;
  float identity;
};

float restLengthOf(Spring spring) { return float(spring.rest) * spring.restResolution; }

// |e| - L
float strutExcess(Edge e, Spring spring) {
#ifdef PRECISE
  double rest = double(spring.rest) * double(spring.restResolution);
  return float(e.square - rest * rest) / (sqrt(2.0 * e.halfSquare) + float(rest));
#else
  return sqrt(e.square) - restLengthOf(spring);
#endif
}

// (|e| - L) / L
float strutStrain(Edge e, Spring spring) { return strutExcess(e, spring) / restLengthOf(spring); }

float inverseLengthOf(Edge e) { return inversesqrt(2.0 * e.halfSquare); }

// k
float strutStretch(Edge e, Spring spring) {
#ifdef PRECISE
  return strutExcess(e, spring) * inverseLengthOf(e);
#else
  return 1.0 - restLengthOf(spring) * inverseLengthOf(e);
#endif
}

// |e|^2 k^2 in single precision, where |e| - L would cost a root.
Squared strutEnergy(Edge e, Spring spring) {
#ifdef PRECISE
  double excess = sqrt(e.square) - double(spring.rest) * double(spring.restResolution);
  return spring.stiffness * excess * excess;
#else
  float stretch = strutStretch(e, spring);
  return spring.stiffness * stretch * stretch * e.square;
#endif
}

// 2 c k e
StrutGradient strutGradient(Edge e, Spring spring) {
  float diagonal = 2.0 * spring.stiffness * strutStretch(e, spring);
  return StrutGradient(vec2(diagonal, 0.0), strutEnergy(e, spring));
}

// 2 c (n n^T + k (I - n n^T))
StrutHessian strutHessian(Edge e, Spring spring, float stretch) {
  float outer = (1.0 - stretch) * inverseLengthOf(e) * inverseLengthOf(e);
  return StrutHessian(2.0 * spring.stiffness * outer, 2.0 * spring.stiffness * stretch);
}

StrutHessian strutExactHessian(Edge e, Spring spring) {
  return strutHessian(e, spring, strutStretch(e, spring));
}

// Leaves out what compression would subtract, so that it is positive semidefinite.
StrutHessian strutGaussNewtonHessian(Edge e, Spring spring) {
  return strutHessian(e, spring, max(0.0, strutStretch(e, spring)));
}

StrutGradient strutProduct(Edge e, StrutHessian hessian) {
  return StrutGradient(vec2(hessian.outer * e.along, hessian.identity), Squared(0));
}

StrutGradient strutTerm(int derivative, Edge e, Spring spring) {
  if (derivative == kGradient) {
    return strutGradient(e, spring);
  }
  return derivative == kExactProduct ? strutProduct(e, strutExactHessian(e, spring))
                                     : strutProduct(e, strutGaussNewtonHessian(e, spring));
}
#endif
