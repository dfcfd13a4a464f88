// Rigid motions of points, and the blocks of 6 x 6 that act on them (shared/multigrid_types.h).
#ifndef MORPHGRID_SOLVE_BLOCK
#define MORPHGRID_SOLVE_BLOCK
struct Motion {
  vec3 t;
  vec3 w;
};

// Rows first: tw multiplies rotations and gives forces.
struct Block {
  mat3 tt, tw, wt, ww;
};

const Motion kNoMotion = Motion(vec3(0), vec3(0));
const Block kNoBlock = Block(mat3(0), mat3(0), mat3(0), mat3(0));

Motion sum(Motion a, Motion b) { return Motion(a.t + b.t, a.w + b.w); }

Motion multiply(Block a, Motion x) {
  return Motion(a.tt * x.t + a.tw * x.w, a.wt * x.t + a.ww * x.w);
}

Motion multiplyTransposed(Block a, Motion x) {
  return Motion(x.t * a.tt + x.w * a.wt, x.t * a.tw + x.w * a.ww);
}

Block transposed(Block a) {
  return Block(transpose(a.tt), transpose(a.wt), transpose(a.tw), transpose(a.ww));
}

void add(inout Block sum, float weight, Block a) {
  sum.tt += weight * a.tt;
  sum.tw += weight * a.tw;
  sum.wt += weight * a.wt;
  sum.ww += weight * a.ww;
}

void addOuter(inout Block sum, float weight, Motion a, Motion b) {
  vec3 t = weight * a.t;
  vec3 w = weight * a.w;
  sum.tt += outerProduct(t, b.t);
  sum.tw += outerProduct(t, b.w);
  sum.wt += outerProduct(w, b.t);
  sum.ww += outerProduct(w, b.w);
}

// [y]x m
mat3 crossed(vec3 y, mat3 m) { return mat3(cross(y, m[0]), cross(y, m[1]), cross(y, m[2])); }

// -m [y]x
mat3 crossedFromRight(mat3 m, vec3 y) { return transpose(crossed(y, transpose(m))); }

// What acts on (t, w) as `a` acts on (t + w x y, w).
Block withLever(Block a, vec3 y) {
  return Block(a.tt, a.tw + crossedFromRight(a.tt, y), a.wt, a.ww + crossedFromRight(a.wt, y));
}

// The same for what `a` gives: the torque of its force is added.
Block withLeverOfRow(vec3 y, Block a) {
  return Block(a.tt, a.tw, a.wt + crossed(y, a.tt), a.ww + crossed(y, a.tw));
}

Block unpackBlock(vec4 a, vec4 b, vec4 c, vec4 d, vec4 e, vec4 f, vec4 g, vec4 h, vec4 i) {
  return Block(mat3(a.xyz, b.xyz, c.xyz), mat3(d.xyz, e.xyz, f.xyz), mat3(g.xyz, h.xyz, i.xyz),
               mat3(a.w, b.w, c.w, d.w, e.w, f.w, g.w, h.w, i.w));
}

// Three image buffers hold a field of blocks, one a point.
#define BLOCK_AT(a, b, c, point)                                                             \
  unpackBlock(imageLoad(a, 3 * (point)), imageLoad(a, 3 * (point) + 1),                      \
              imageLoad(a, 3 * (point) + 2), imageLoad(b, 3 * (point)),                      \
              imageLoad(b, 3 * (point) + 1), imageLoad(b, 3 * (point) + 2),                  \
              imageLoad(c, 3 * (point)), imageLoad(c, 3 * (point) + 1),                      \
              imageLoad(c, 3 * (point) + 2))

#define STORE_COLUMNS(part, point, quarter, corner)   \
  part[3 * (point)] = vec4(quarter[0], corner.x);     \
  part[3 * (point) + 1] = vec4(quarter[1], corner.y); \
  part[3 * (point) + 2] = vec4(quarter[2], corner.z)

#define STORE_BLOCK(a, b, c, point, block)            \
  STORE_COLUMNS(a, point, (block).tt, (block).ww[0]); \
  STORE_COLUMNS(b, point, (block).tw, (block).ww[1]); \
  STORE_COLUMNS(c, point, (block).wt, (block).ww[2])

#define MOTION_AT(vectors, point) \
  Motion(imageLoad(vectors, 2 * (point)).xyz, imageLoad(vectors, 2 * (point) + 1).xyz)

#define STORE_MOTION(result, point, motion)        \
  result[2 * (point)] = vec4((motion).t, 0.0);     \
  result[2 * (point) + 1] = vec4((motion).w, 0.0)
#endif
