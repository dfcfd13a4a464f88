// What a strut's colour shows: its strain, or with kShowsShares a share of its own.
#include "render/strut.glsl"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;

layout(binding = kBindingRest) uniform isamplerBuffer restLengths;
layout(binding = kBindingShares) uniform samplerBuffer shares;

layout(location = 0) flat out float shown;
layout(location = 6) out float behind;  // 0 in the layer next to the eye, 1 in the farthest; of shares 0.

// How far behind the other layers this strut lies, from the column at its beginning.
float placeBehind(Strut strut) {
  int layers = push.size.z;
  if (layers == 1) {
    return 0;
  }
  ivec3 lower = ivec3(strut.lattice.xy, min(strut.lattice.z, layers - 2));
  vec3 sight = push.eye - strut.start;
  vec3 upwards = armBetween(
      texelFetch(positions, vertexIndex(push.size, lower)),
      texelFetch(positions, vertexIndex(push.size, neighbour(lower, 2, 1))), push.resolution);
  float facingUp = dot(upwards, sight) / max(length(upwards) * length(sight), 1e-20);
  float height = float(strut.lattice.z) + (push.direction == 2 ? 0.5 : 0);
  float aboveMiddle = 2 * height / float(layers - 1) - 1;
  // Steep, but no step: where the eye looks along the layers none is in front.
  return 0.5 - 0.5 * aboveMiddle * clamp(4 * facingUp, -1, 1);
}

void show(Strut strut) {
  if (kShowsShares) {
    shown = texelFetch(shares, strut.index)[push.direction];
    behind = 0;
  } else {
    int rest = texelFetch(restLengths, strut.index)[push.direction];
    shown = strutStrain(edgeOf(strut.arm, vec3(0)), Spring(rest, push.restResolution, 1.0));
    behind = placeBehind(strut);
  }
}
