// The joint term: what acts on a joint from outside (docs/method.md, Weight and supports). A force f, its load,
// keeps its direction; springs hold a joint where and as it was printed. Its energy is
// -f . u + sum of holding u^2 / 2 + 2 turning |v|^2. With PRECISE in double precision.
#ifndef MORPHGRID_ENERGY_JOINT
#define MORPHGRID_ENERGY_JOINT
#include "energy/beam.glsl"

struct JointTerm {
  Real3 moved;  // u, since it was printed
  Real3 v;      // Of its rotation's quaternion (v, w).
  Real w;
  Real3 load;     // f
  vec3 holding;   // Stiffnesses, 0 where it is free.
  float turning;
};

struct JointForces {
  Real3 force;
  Real3 moment;
};

Real jointEnergy(JointTerm term) {
  return Real(0.5) * dot(Real3(term.holding) * term.moved, term.moved) +
         Real(2.0 * term.turning) * dot(term.v, term.v) - dot(term.load, term.moved);
}

JointForces jointGradient(JointTerm term) {
  return JointForces(Real3(term.holding) * term.moved - term.load, Real(2.0 * term.turning) * term.w * term.v);
}

// displacement, turn: how the joint moves.
JointForces jointGaussNewtonProduct(JointTerm term, vec3 displacement, vec3 turn) {
  return JointForces(Real3(term.holding * displacement), Real3(term.turning * turn));
}

JointForces jointExactProduct(JointTerm term, vec3 displacement, vec3 turn) {
  vec3 v = vec3(term.v);
  float w = float(term.w);
  vec3 moment = w * w * turn - dot(v, turn) * v + w * cross(turn, v);
  return JointForces(Real3(term.holding * displacement), Real3(term.turning * moment));
}
#endif
