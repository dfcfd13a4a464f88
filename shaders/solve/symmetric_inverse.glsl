// Inverses of symmetric 3 x 3 matrices that may be singular.
struct Symmetric {
  vec3 diagonal;
  vec3 off;  // yz, xz, xy
};

// Inverts by L D L^T without pivoting: the inverse is the sum of m m^T / pivot over the rows m of
// L^-1. A pivot that is not above its `least` counts as absent: its row and column of the inverse
// are zero.
Symmetric inverseOf(Symmetric a, vec3 least) {
  float px = a.diagonal.x;
  float ix = px > least.x ? 1.0 / px : 0.0;
  float yx = a.off.z * ix, zx = a.off.y * ix;
  float py = a.diagonal.y - yx * a.off.z;
  float iy = py > least.y ? 1.0 / py : 0.0;
  float zyUnscaled = a.off.x - zx * a.off.z;
  float zy = zyUnscaled * iy;
  float pz = a.diagonal.z - zx * a.off.y - zy * zyUnscaled;
  float iz = pz > least.z ? 1.0 / pz : 0.0;
  vec3 y = vec3(-yx, 1.0, 0.0);
  vec3 z = vec3(yx * zy - zx, -zy, 1.0);
  return Symmetric(vec3(ix, 0, 0) + iy * y * y + iz * z * z,
                   iy * y.yxx * y.zzy + iz * z.yxx * z.zzy);
}

vec3 diagonalOf(mat3 m) { return vec3(m[0][0], m[1][1], m[2][2]); }

// The same for a matrix of which only the lower left half counts.
mat3 inverseOf(mat3 m, vec3 least) {
  Symmetric a = inverseOf(Symmetric(diagonalOf(m), vec3(m[1][2], m[0][2], m[0][1])), least);
  return mat3(a.diagonal.x, a.off.z, a.off.y, a.off.z, a.diagonal.y, a.off.x, a.off.y, a.off.x,
              a.diagonal.z);
}
