// Energy and its gradient. Lengths in spacings, energies in stiffness x spacing^2.
#include "energy/derivative.glsl"
#include "shared/hessian_types.h"

const int kDerivative = kGradient;
const bool kMeasure = true;

layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 gradients[]; };
layout(push_constant) uniform Push { GridPush push; };

#define GRID push
#define DAMPING 0.0
#ifdef PRECISE
#define Sum double
#else
#define Sum float
#endif
#include "solve/columns.glsl"

#include "solve/gradient_partials.glsl"

Vertex vertexAt(int index) { return Vertex(imageLoad(positions, index), vec3(0)); }

void finish(int index, bool owned, Vertex vertex, vec3 gradient, float stepPerForce) {
  if (owned) {
    gradients[index] = vec4(gradient, 0.0);
  }
  squaredGradient += owned ? dot(gradient, gradient) : 0.0;
}

void main() {
  findRing(true);
  walkColumns();
  writePartials();
}
