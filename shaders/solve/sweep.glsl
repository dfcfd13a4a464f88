// One sweep of Jacobi-style projective dynamics with Chebyshev acceleration: every strut and corner is
// projected, every vertex takes the weighted mean of what its constraints want.
// One invocation walks the layers of one column, so that vertical neighbours are loaded once.
// Differences of positions cancel: near equilibrium their rounding in single precision, and nothing
// else, sets the smallest residual. With PRECISE they and their dot products are doubles.
#include "shared/solver_types.h"
#include "solve/arm.glsl"
#include "solve/corner.glsl"

layout(local_size_x = kSweepColumnsU, local_size_y = kSweepColumnsV) in;
layout(constant_id = 0) const bool kMeasure = false;
layout(constant_id = 1) const bool kPlanar = false;  // A single layer, moving in its plane.

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(std430, binding = kBindingNextPositions) buffer NextPositions { ivec4 next[]; };
layout(binding = kBindingRest) uniform isamplerBuffer restLengths;
layout(binding = kBindingStiffness) uniform samplerBuffer stiffnesses;
layout(std430, binding = kBindingState) readonly buffer State { SolverState state; };
layout(std430, binding = kBindingPartials) writeonly buffer Partials { vec4 partials[]; };
layout(push_constant) uniform Push { SweepPush push; };

shared vec4 sums[kSweepColumnsU * kSweepColumnsV];

// Spacings that a vertex may move in one sweep; keeps a wild start within the fixed-point range.
const float kLargestMove = 1.0;
const float kRelaxation = 0.9;

Arm difference(ivec4 to, ivec4 from) { return armBetween(from, to, push.resolution); }

// p + delta; delta in steps of the fixed point.
ivec4 moved(ivec4 p, vec3 delta) {
  vec3 whole = floor(delta);
  ivec3 extra = extraBits(p) + ivec3((delta - whole) * kExtraSteps + 0.5);
  ivec3 xyz = p.xyz + ivec3(whole) + (extra >> int(kExtraBits));
  extra &= kExtraMask;
  return ivec4(xyz, extra.x | (extra.y << kExtraBits) | (extra.z << (2 * kExtraBits)));
}

// Adds up over the constraints of one vertex; gradients are with respect to the vertex.
struct Pull {
  vec3 struts;
  vec3 corners;  // per angle weight
};

float energy = 0.0;  // of the column's own struts and apexes
float squaredGradient = 0.0;
float gradientAlongVelocity = 0.0;

// Gradient of w c (|e| - L)^2 at the end of e; rest in steps of push.restResolution.
vec3 strutGradient(Arm e, Squared ee, int rest, float stiffness) {
  float squaredLength = max(float(ee), 1e-20);
  return 2.0 * stiffness * lengthExcess(ee, rest, push.restResolution) *
         inversesqrt(squaredLength) * vec3(e);
}

float strutEnergy(Squared ee, int rest, float stiffness) {
  float excess = lengthExcess(ee, rest, push.restResolution);
  return stiffness * excess * excess;
}

// A corner at this vertex; returns the pull on the end of b.
vec3 addApex(inout Pull pull, Arm a, Arm b, Squared aa, Squared bb) {
  Corner corner = projectCorner(a, b, aa, bb);
  pull.corners -= (corner.own + corner.other) * vec3(a + b);
  if (kMeasure) {
    energy += push.angleWeight * corner.energy;
  }
  return corner.own * vec3(b) + corner.other * vec3(a);
}

// A corner at a neighbour: a leads from there to this vertex, b to another one.
void addArm(inout Pull pull, Arm a, Arm b, Squared aa) {
  Corner corner = projectCorner(a, b, aa, dot(b, b));
  pull.corners += corner.own * vec3(a) + corner.other * vec3(b);
}

void finish(int index, ivec4 position, Pull pull, float stepPerForce, float momentum) {
  ivec4 previous = next[index];
  vec3 velocity = stepsBetween(previous, position);
  vec3 gradient = pull.struts + push.angleWeight * pull.corners;
  vec3 jump = -(1.0 + momentum) * kRelaxation * stepPerForce / push.resolution * gradient;
  float largest = kLargestMove / push.resolution;
  next[index] = moved(position, clamp(momentum * velocity + jump, -largest, largest));
  if (kMeasure) {
    squaredGradient += dot(gradient, gradient);
    gradientAlongVelocity += dot(gradient, velocity) * push.resolution;
  }
}

// The column's neighbours in one layer.
struct Ring {
  ivec4 center, west, east, south, north;
};

void sweepColumn(ivec2 column) {
  int rowLength = push.verticesU;
  int layerLength = push.verticesU * push.verticesV;
  int center = column.y * rowLength + column.x;
  // Beyond the border a neighbour is the vertex itself, its arm the zero vector.
  int west = column.x > 0 ? -1 : 0;
  int east = column.x + 1 < push.verticesU ? 1 : 0;
  int south = column.y > 0 ? -rowLength : 0;
  int north = column.y + 1 < push.verticesV ? rowLength : 0;

  // Chebyshev semi-iteration whose assumed condition grows with the sweeps since the last restart.
  float sweeps = float(state.sweepsSinceRestart + push.sweep);
  float momentum = sweeps / (sweeps + 2.0);
  momentum *= momentum;

  Ring here = Ring(texelFetch(positions, center), texelFetch(positions, center + west),
                   texelFetch(positions, center + east), texelFetch(positions, center + south),
                   texelFetch(positions, center + north));
  ivec4 below = here.center;
  Arm downWest = Arm(0), downEast = Arm(0), downSouth = Arm(0), downNorth = Arm(0);
  Arm down = Arm(0);
  vec3 downStrutGradient = vec3(0);  // of the strut below, at its upper end
  Pull belowPull = Pull(vec3(0), vec3(0));
  float belowStep = 0.0;
  vec3 carriedUp = vec3(0);  // pull of the corners below on this vertex

  for (int layer = 0; layer < push.layers; ++layer) {
    int index = center + layer * layerLength;
    ivec4 rest = texelFetch(restLengths, index);
    vec4 stiffness = texelFetch(stiffnesses, index);

    Arm e = difference(here.east, here.center), w = difference(here.west, here.center);
    Arm n = difference(here.north, here.center), s = difference(here.south, here.center);
    Squared ee = dot(e, e), ww = dot(w, w), nn = dot(n, n), ss = dot(s, s);

    Pull pull = Pull(vec3(0), carriedUp);
    pull.struts -= strutGradient(e, ee, rest.x, stiffness.x);
    pull.struts -= strutGradient(n, nn, rest.y, stiffness.y);
    pull.struts -= strutGradient(w, ww, texelFetch(restLengths, index + west).x,
                                 texelFetch(stiffnesses, index + west).x);
    pull.struts -= strutGradient(s, ss, texelFetch(restLengths, index + south).y,
                                 texelFetch(stiffnesses, index + south).y);
    if (kMeasure) {
      energy += strutEnergy(ee, rest.x, stiffness.x) + strutEnergy(nn, rest.y, stiffness.y);
    }

    addApex(pull, e, n, ee, nn);
    addApex(pull, e, s, ee, ss);
    addApex(pull, w, n, ww, nn);
    addApex(pull, w, s, ww, ss);

    Arm northEast = difference(texelFetch(positions, index + north + east), here.center);
    Arm northWest = difference(texelFetch(positions, index + north + west), here.center);
    Arm southEast = difference(texelFetch(positions, index + south + east), here.center);
    Arm southWest = difference(texelFetch(positions, index + south + west), here.center);
    addArm(pull, -e, northEast - e, ee);
    addArm(pull, -e, southEast - e, ee);
    addArm(pull, -w, northWest - w, ww);
    addArm(pull, -w, southWest - w, ww);
    addArm(pull, -n, northEast - n, nn);
    addArm(pull, -n, northWest - n, nn);
    addArm(pull, -s, southEast - s, ss);
    addArm(pull, -s, southWest - s, ss);

    if (kPlanar) {
      finish(index, here.center, pull, intBitsToFloat(rest.w), momentum);
      return;
    }

    int up = layer + 1 < push.layers ? layerLength : 0;
    Ring above = Ring(texelFetch(positions, index + up), texelFetch(positions, index + up + west),
                      texelFetch(positions, index + up + east),
                      texelFetch(positions, index + up + south),
                      texelFetch(positions, index + up + north));
    Arm u = difference(above.center, here.center);
    Arm upEast = difference(above.east, here.east), upWest = difference(above.west, here.west);
    Arm upNorth = difference(above.north, here.north);
    Arm upSouth = difference(above.south, here.south);
    Squared uu = dot(u, u), dd = dot(down, down);

    vec3 upStrutGradient = strutGradient(u, uu, rest.z, stiffness.z);
    pull.struts += downStrutGradient - upStrutGradient;
    if (kMeasure) {
      energy += strutEnergy(uu, rest.z, stiffness.z);
    }

    carriedUp = addApex(pull, e, u, ee, uu);
    carriedUp += addApex(pull, w, u, ww, uu);
    carriedUp += addApex(pull, n, u, nn, uu);
    carriedUp += addApex(pull, s, u, ss, uu);
    belowPull.corners += addApex(pull, e, down, ee, dd);
    belowPull.corners += addApex(pull, w, down, ww, dd);
    belowPull.corners += addApex(pull, n, down, nn, dd);
    belowPull.corners += addApex(pull, s, down, ss, dd);

    addArm(pull, -e, upEast, ee);
    addArm(pull, -e, downEast, ee);
    addArm(pull, -w, upWest, ww);
    addArm(pull, -w, downWest, ww);
    addArm(pull, -n, upNorth, nn);
    addArm(pull, -n, downNorth, nn);
    addArm(pull, -s, upSouth, ss);
    addArm(pull, -s, downSouth, ss);

    if (layer > 0) {
      finish(index - layerLength, below, belowPull, belowStep, momentum);
    }
    if (layer + 1 == push.layers) {
      finish(index, here.center, pull, intBitsToFloat(rest.w), momentum);
    }
    below = here.center;
    belowPull = pull;
    belowStep = intBitsToFloat(rest.w);
    down = -u;
    downEast = -upEast;
    downWest = -upWest;
    downNorth = -upNorth;
    downSouth = -upSouth;
    downStrutGradient = upStrutGradient;
    here = above;
  }
}

// Pairwise sums over the workgroup: accurate and the same in every run.
void writePartials() {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = vec4(energy, squaredGradient, gradientAlongVelocity, 0.0);
  for (uint stride = kSweepColumnsU * kSweepColumnsV / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] += sums[lane + stride];
    }
  }
  if (lane == 0u) {
    partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sums[0];
  }
}

void main() {
  ivec2 column = ivec2(gl_GlobalInvocationID.xy);
  if (state.done == 0u && column.x < push.verticesU && column.y < push.verticesV) {
    sweepColumn(column);
  }
  if (kMeasure) {
    writePartials();
  }
}
