// What a strut shows of its strain. Before: placeCorner().
layout(binding = kBindingRest) uniform isamplerBuffer restLengths;

layout(location = 0) flat out float strain;
layout(location = 6) out float behind;  // 0 in the layer next to the eye, 1 in the farthest.

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

void main() {
  Strut strut = placeCorner();
  int rest = texelFetch(restLengths, strut.index)[push.direction];
  strain = strutStrain(edgeOf(strut.arm, vec3(0)), Spring(rest, push.restResolution, 1.0));
  behind = placeBehind(strut);
}
