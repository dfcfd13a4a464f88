// D^-1, D the blocks of 3 x 3 on the Hessian's diagonal: symmetric, a vertex's in two texels.
layout(binding = kBindingInverseDiagonal, rgba32f) readonly uniform imageBuffer inverseDiagonal;
layout(binding = kBindingInverseOffDiagonal, rgba32f) readonly uniform imageBuffer inverseOffDiagonal;

vec3 multiplyInverse(int index, vec3 b) {
  vec3 diagonal = imageLoad(inverseDiagonal, index).xyz;
  vec3 off = imageLoad(inverseOffDiagonal, index).xyz;  // yz, xz, xy
  return diagonal * b + off.zxy * b.yzx + off.yzx * b.zxy;
}
