// The beam term: a bar that is welded to its two joints, a and b, which move and turn (docs/method.md, A
// frame of welded bars). Its energy is the sum of stiffness x strain^2 / 2 over six strains: the stretch, two
// ways to bend, two to take the shape of an S, and the twist. With PRECISE in double precision.
#ifndef MORPHGRID_ENERGY_BEAM
#define MORPHGRID_ENERGY_BEAM
#include "energy/arm.glsl"
#include "shared/frame_types.h"

#define Real Squared
#define Real3 Arm
#ifdef PRECISE
#define Real2 dvec2
#define Real4 dvec4
#else
#define Real2 vec2
#define Real4 vec4
#endif

// Where a bar has turned by nearly 180 degrees against its joint, what divides counts as no less than this.
const float kLeastDenominator = 1e-3;

struct Joint {
  ivec4 position;
  ivec4 rotation;
};

struct Strains {
  Real stretch;
  Real2 bend;   // c, in the sheet's plane as printed (about b), and across (about n)
  Real2 shear;  // h, alike: the angles' sum
  Real twist;   // p, the tangent of half the angle
};

const Strains kNoStrains = Strains(Real(0), Real2(0), Real2(0), Real(0));

// A bar's directions at one of its ends, which turn with the joint: t along it, n in the sheet's plane, b
// across. v: how the angles between bar and joint change with the bar's direction.
struct BarEnd {
  Real3 t, n, b;
  Real2 angles;  // theta
  Real3 vn, vb;
};

struct Beam {
  BarEnd a, b;
  Real3 along;     // e, of the flexible part
  Real chord;      // l
  float rest;      // L, of the flexible part
  float joint;     // r, the rigid part at either end
  Real3 twisting;  // The twist changes by this . (turn of a - turn of b).
  Strains strains;
};

// How a bar's ends move.
struct BarMotion {
  vec3 change;  // of x_b - x_a
  vec3 turnA, turnB;
};

// What a bar's energy changes by with its ends: its gradient by x_b, the opposite of that by x_a, and those by
// turns of the joints.
struct BarForces {
  Real3 force;
  Real3 momentA, momentB;
};

Real3 rotated(Real4 q, Real3 x) {
  Real3 across = cross(q.xyz, x);
  return x + Real(2) / dot(q, q) * (q.w * across + cross(q.xyz, across));
}

// direction: the cosine and sine of a lateral bar's direction in the sheet.
BarEnd barEndAt(Joint joint, vec2 direction, bool isUpright) {
  Real4 q = Real4(joint.rotation) / Real(1 << int(kRotationBits));
  Real3 x = rotated(q, Real3(1, 0, 0)), y = rotated(q, Real3(0, 1, 0));
  Real3 z = cross(x, y);
  Real c = Real(direction.x), s = Real(direction.y);
  return isUpright ? BarEnd(z, x, y, Real2(0), Real3(0), Real3(0))
                   : BarEnd(c * x + s * y, c * y - s * x, z, Real2(0), Real3(0), Real3(0));
}

// theta = s f(c), c = e . t, s = e . n: the angle but for its fifth power.
void findAngles(inout BarEnd end, Real3 along) {
  Real inverse = Real(1) / max(Real(1) + dot(along, end.t), Real(kLeastDenominator));
  Real f = (Real(1) + Real(4) * inverse) / Real(3);
  Real slope = Real(-4.0 / 3.0) * inverse * inverse;
  Real2 sines = Real2(dot(along, end.n), dot(along, end.b));
  end.angles = f * sines;
  end.vn = f * end.n + (slope * sines.x) * end.t;
  end.vb = f * end.b + (slope * sines.y) * end.t;
}

void findTwist(inout Beam beam) {
  BarEnd a = beam.a, b = beam.b;
  Real sum = Real(1) + dot(a.t, b.t) + dot(a.n, b.n) + dot(a.b, b.b);
  Real inverse = Real(1) / max(sum, Real(kLeastDenominator));
  Real twist = (dot(a.n, b.b) - dot(a.b, b.n)) * inverse;
  beam.strains.twist = twist;
  beam.twisting = inverse * (cross(a.n, b.b) - cross(a.b, b.n) -
                             twist * (cross(a.t, b.t) + cross(a.n, b.n) + cross(a.b, b.b)));
}

// arm: x_b - x_a. rest: the bar's whole length.
Beam beamBetween(BarEnd a, BarEnd b, Real3 arm, float rest, float joint) {
  Beam beam;
  Real3 flexible = arm - Real(joint) * (a.t + b.t);
  Real square = dot(flexible, flexible);
  beam.chord = sqrt(square);
  beam.along = flexible / beam.chord;
  findAngles(a, beam.along);
  findAngles(b, beam.along);
  beam.a = a;
  beam.b = b;
  beam.rest = rest - 2.0 * joint;
  beam.joint = joint;
  Real2 bend = a.angles - b.angles, shear = a.angles + b.angles;
  beam.strains.bend = bend;
  beam.strains.shear = shear;
  // The arc is that much longer than its chord.
  beam.strains.stretch = (beam.chord - Real(beam.rest)) / Real(beam.rest) +
                         (Real(5) * dot(bend, bend) + Real(3) * dot(shear, shear)) / Real(120);
  findTwist(beam);
  return beam;
}

Strains stressesOf(DeviceBarSection section, Beam beam, Strains strains) {
  Real2 bending = Real2(section.bendingN, section.bendingB) / Real(beam.rest);
  Real2 phi = Real(12.0 * section.shearing / beam.rest) * bending;
  return Strains(Real(section.stretching * beam.rest) * strains.stretch, bending * strains.bend,
                 Real(3) * bending / (Real(1) + phi) * strains.shear,
                 Real(4.0 * section.twisting / beam.rest) * strains.twist);
}

// How the energy changes with the angles at either end, [0] at a, [1] at b.
void bendingMoments(Beam beam, Strains stresses, Strains strains, out Real2 atA, out Real2 atB) {
  Real2 bend = stresses.bend + stresses.stretch / Real(12) * strains.bend;
  Real2 shear = stresses.shear + stresses.stretch / Real(20) * strains.shear;
  atA = shear + bend;
  atB = shear - bend;
}

// The work of stresses, derived by the ends. tension: a force across the bar that is added.
BarForces forcesOf(Beam beam, Strains stresses, Real3 tension) {
  Real2 atA, atB;
  bendingMoments(beam, stresses, beam.strains, atA, atB);
  Real3 byA = atA.x * beam.a.vn + atA.y * beam.a.vb;
  Real3 byB = atB.x * beam.b.vn + atB.y * beam.b.vb;
  Real3 e = beam.along;
  Real3 both = byA + byB;
  Real3 force = stresses.stretch / Real(beam.rest) * e + (both - dot(e, both) * e) / beam.chord + tension;
  Real3 twisting = stresses.twist * beam.twisting;
  return BarForces(force, cross(byA, e) - Real(beam.joint) * cross(beam.a.t, force) + twisting,
                   cross(byB, e) - Real(beam.joint) * cross(beam.b.t, force) - twisting);
}

BarForces beamGradient(DeviceBarSection section, Beam beam) {
  return forcesOf(beam, stressesOf(section, beam, beam.strains), Real3(0));
}

Real beamEnergy(DeviceBarSection section, Beam beam) {
  Strains s = beam.strains;
  Strains stresses = stressesOf(section, beam, s);
  return Real(0.5) * (stresses.stretch * s.stretch + dot(stresses.bend, s.bend) +
                      dot(stresses.shear, s.shear) + stresses.twist * s.twist);
}

// How the flexible part's chord changes.
Real3 changeOfChord(Beam beam, BarMotion z) {
  return Real3(z.change) -
         Real(beam.joint) * (cross(Real3(z.turnA), beam.a.t) + cross(Real3(z.turnB), beam.b.t));
}

Real2 changeOfAngles(BarEnd end, Real3 along, Real3 changeOfAlong, Real3 turn) {
  return Real2(dot(end.vn, changeOfAlong) + dot(cross(end.vn, along), turn),
               dot(end.vb, changeOfAlong) + dot(cross(end.vb, along), turn));
}

Strains changeOfStrains(Beam beam, BarMotion z) {
  Real3 chord = changeOfChord(beam, z);
  Real stretch = dot(beam.along, chord);
  Real3 changeOfAlong = (chord - stretch * beam.along) / beam.chord;
  Real2 atA = changeOfAngles(beam.a, beam.along, changeOfAlong, Real3(z.turnA));
  Real2 atB = changeOfAngles(beam.b, beam.along, changeOfAlong, Real3(z.turnB));
  Real2 bend = atA - atB, shear = atA + atB;
  return Strains(stretch / Real(beam.rest) + dot(beam.strains.bend, bend) / Real(12) +
                     dot(beam.strains.shear, shear) / Real(20),
                 bend, shear, dot(beam.twisting, Real3(z.turnA - z.turnB)));
}

// What a bar under tension does against turns of its chord; compression would subtract, and is left out, so
// that the Gauss-Newton Hessian is positive semidefinite.
Real stiffnessAcross(DeviceBarSection section, Beam beam) {
  return Real(section.stretching) * max(beam.strains.stretch, Real(0)) / beam.chord;
}

BarForces beamGaussNewtonProduct(DeviceBarSection section, Beam beam, BarMotion z) {
  Real3 chord = changeOfChord(beam, z);
  Real3 across = chord - dot(beam.along, chord) * beam.along;
  return forcesOf(beam, stressesOf(section, beam, changeOfStrains(beam, z)),
                  stiffnessAcross(section, beam) * across);
}
#endif
