// Energy of a frame and its gradient. Lengths in spacings, energies in stiffness x spacing^2.
#ifdef PRECISE
#define Sum double
#else
#define Sum float
#endif
#include "solve/frame_sum.glsl"
#include "solve/gradient_partials.glsl"

layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 gradients[]; };

BarForces barForces(DeviceBarSection section, Beam beam, BarMotion z) { return beamGradient(section, beam); }

BarMotion barMotion(int indexA, int indexB) { return BarMotion(vec3(0), vec3(0), vec3(0)); }

JointForces jointForces(JointTerm term, int index) { return jointGradient(term); }

void finish(int index, Real3 force, Real3 moment) {
  gradients[index] = vec4(force, 0.0);
  gradients[jointCount() + index] = vec4(moment, 0.0);
  squaredGradient += Sum(dot(force, force) + dot(moment, moment));
}

void main() {
  walkColumn();
  writePartials();
}
