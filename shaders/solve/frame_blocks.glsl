// Blocks of a frame's Gauss-Newton Hessian: what a bar adds between two of its ends, each as part of a body
// that moves rigidly about a centre.
#include "solve/block.glsl"
#include "solve/frame.glsl"

struct BarRows {
  BarForces rows[6];  // Of the strains, as forcesOf() of a stress of 1.
  float stiffness[6];
  mat3 across;  // What tension adds against motions across the bar.
  vec3 jointA, jointB;  // From the joint to where the bar's flexible part begins.
};

// Which end, and how far it is from its body's centre.
struct End {
  bool isB;
  vec3 lever;
};

BarRows rowsOf(ivec3 from, int axis) {
  Beam beam = beamFrom(from, axis, jointAt(indexOf(from)), jointAt(indexOf(neighbour(from, axis, 1))));
  DeviceBarSection section = sectionOf(axis);
  BarRows rows;
  rows.rows[0] = forcesOf(beam, Strains(1.0, vec2(0), vec2(0), 0.0), vec3(0));
  rows.rows[1] = forcesOf(beam, Strains(0.0, vec2(1, 0), vec2(0), 0.0), vec3(0));
  rows.rows[2] = forcesOf(beam, Strains(0.0, vec2(0, 1), vec2(0), 0.0), vec3(0));
  rows.rows[3] = forcesOf(beam, Strains(0.0, vec2(0), vec2(1, 0), 0.0), vec3(0));
  rows.rows[4] = forcesOf(beam, Strains(0.0, vec2(0), vec2(0, 1), 0.0), vec3(0));
  rows.rows[5] = forcesOf(beam, Strains(0.0, vec2(0), vec2(0), 1.0), vec3(0));
  Strains ones = stressesOf(section, beam, Strains(1.0, vec2(1), vec2(1), 1.0));
  rows.stiffness = float[](ones.stretch, ones.bend.x, ones.bend.y, ones.shear.x, ones.shear.y, ones.twist);
  rows.across = stiffnessAcross(section, beam) * (mat3(1) - outerProduct(beam.along, beam.along));
  rows.jointA = beam.joint * beam.a.t;
  rows.jointB = -beam.joint * beam.b.t;
  return rows;
}

Motion rowAt(BarForces forces, End end) {
  vec3 force = end.isB ? forces.force : -forces.force;
  vec3 moment = end.isB ? forces.momentB : forces.momentA;
  return Motion(force, moment + cross(end.lever, force));
}

Block ofForces(mat3 stiffness, vec3 armOfRow, vec3 armOfColumn) {
  return withLever(withLeverOfRow(armOfRow, Block(stiffness, mat3(0), mat3(0), mat3(0))), armOfColumn);
}

Block betweenEnds(BarRows rows, End row, End column) {
  Block block = kNoBlock;
  [[unroll]] for (int n = 0; n < 6; ++n) {
    addOuter(block, rows.stiffness[n], rowAt(rows.rows[n], row), rowAt(rows.rows[n], column));
  }
  float sign = row.isB == column.isB ? 1.0 : -1.0;
  vec3 armOfRow = row.lever + (row.isB ? rows.jointB : rows.jointA);
  vec3 armOfColumn = column.lever + (column.isB ? rows.jointB : rows.jointA);
  add(block, sign, ofForces(rows.across, armOfRow, armOfColumn));
  add(block, sign, ofForces(mat3(push.damping), row.lever, column.lever));
  block.ww += mat3(sign * push.damping);
  return block;
}

// What holds a joint, as part of a body about whose centre it has a lever. Nothing where it is free.
Block ofHold(int index, vec3 lever) {
  float share = imageLoad(loads, index).w;
  vec3 holding = share * holdingStiffness();
  mat3 stiffness = mat3(vec3(holding.x, 0, 0), vec3(0, holding.y, 0), vec3(0, 0, holding.z));
  Block block = ofForces(stiffness, lever, lever);
  block.ww += mat3(share * push.turning);
  return block;
}
