// How a beam's gradient changes with its ends, exactly: that of its strains at the present forces, and what
// their change brings. Where joints are at rest it is symmetric.
#include "energy/beam.glsl"

// How a bar's end and what follows from it change.
struct EndChange {
  vec3 t, n, b;
  vec3 vn, vb;
};

EndChange changeOfEnd(BarEnd end, vec3 along, vec3 changeOfAlong, vec3 turn) {
  EndChange change;
  change.t = cross(turn, end.t);
  change.n = cross(turn, end.n);
  change.b = cross(turn, end.b);
  float inverse = 1.0 / max(1.0 + dot(along, end.t), kLeastDenominator);
  float f = (1.0 + 4.0 * inverse) / 3.0;
  float slope = -4.0 / 3.0 * inverse * inverse;
  float byCosine = dot(changeOfAlong, end.t) + dot(along, change.t);
  float changeOfF = slope * byCosine;
  float changeOfSlope = -2.0 * slope * inverse * byCosine;
  float sineN = dot(along, end.n), sineB = dot(along, end.b);
  float bySineN = dot(changeOfAlong, end.n) + dot(along, change.n);
  float bySineB = dot(changeOfAlong, end.b) + dot(along, change.b);
  change.vn = f * change.n + changeOfF * end.n + (slope * sineN) * change.t +
              (slope * bySineN + changeOfSlope * sineN) * end.t;
  change.vb = f * change.b + changeOfF * end.b + (slope * sineB) * change.t +
              (slope * bySineB + changeOfSlope * sineB) * end.t;
  return change;
}

vec3 changeOfTwisting(Beam beam, EndChange a, EndChange b, float changeOfTwist) {
  BarEnd p = beam.a, q = beam.b;
  float sum = 1.0 + dot(p.t, q.t) + dot(p.n, q.n) + dot(p.b, q.b);
  float inverse = 1.0 / max(sum, kLeastDenominator);
  float changeOfSum = dot(a.t, q.t) + dot(p.t, b.t) + dot(a.n, q.n) + dot(p.n, b.n) +
                      dot(a.b, q.b) + dot(p.b, b.b);
  vec3 axes = cross(p.t, q.t) + cross(p.n, q.n) + cross(p.b, q.b);
  vec3 changeOfAxes = cross(a.t, q.t) + cross(p.t, b.t) + cross(a.n, q.n) + cross(p.n, b.n) +
                      cross(a.b, q.b) + cross(p.b, b.b);
  vec3 change = cross(a.n, q.b) + cross(p.n, b.b) - cross(a.b, q.n) - cross(p.b, b.n) -
                changeOfTwist * axes - beam.strains.twist * changeOfAxes;
  return inverse * (change - changeOfSum * beam.twisting);
}

BarForces beamExactProduct(DeviceBarSection section, Beam beam, BarMotion z) {
  vec3 e = beam.along;
  vec3 chord = changeOfChord(beam, z);
  float stretch = dot(e, chord);
  vec3 changeOfAlong = (chord - stretch * e) / beam.chord;
  EndChange a = changeOfEnd(beam.a, e, changeOfAlong, z.turnA);
  EndChange b = changeOfEnd(beam.b, e, changeOfAlong, z.turnB);
  Strains change = changeOfStrains(beam, z);
  Strains stresses = stressesOf(section, beam, beam.strains);

  vec2 atA, atB, byStrainsA, byStrainsB;
  bendingMoments(beam, stresses, beam.strains, atA, atB);
  bendingMoments(beam, Strains(stresses.stretch, vec2(0), vec2(0), 0.0), change, byStrainsA, byStrainsB);
  vec3 byA = atA.x * beam.a.vn + atA.y * beam.a.vb;
  vec3 byB = atB.x * beam.b.vn + atB.y * beam.b.vb;
  vec3 changeByA = atA.x * a.vn + atA.y * a.vb + byStrainsA.x * beam.a.vn + byStrainsA.y * beam.a.vb;
  vec3 changeByB = atB.x * b.vn + atB.y * b.vb + byStrainsB.x * beam.b.vn + byStrainsB.y * beam.b.vb;

  vec3 both = byA + byB;
  vec3 changeOfBoth = changeByA + changeByB;
  vec3 across = both - dot(e, both) * e;
  float tension = stresses.stretch / beam.rest;
  vec3 force = tension * e + across / beam.chord;
  vec3 changeOfAcross = changeOfBoth - dot(e, both) * changeOfAlong -
                        (dot(changeOfAlong, both) + dot(e, changeOfBoth)) * e;
  vec3 changeOfForce = tension * changeOfAlong + changeOfAcross / beam.chord -
                       stretch / (beam.chord * beam.chord) * across;
  vec3 twisting = stresses.twist * changeOfTwisting(beam, a, b, change.twist);
  vec3 momentA = cross(changeByA, e) + cross(byA, changeOfAlong) -
                 beam.joint * (cross(a.t, force) + cross(beam.a.t, changeOfForce)) + twisting;
  vec3 momentB = cross(changeByB, e) + cross(byB, changeOfAlong) -
                 beam.joint * (cross(b.t, force) + cross(beam.b.t, changeOfForce)) - twisting;

  BarForces byStress = forcesOf(beam, stressesOf(section, beam, change), vec3(0));
  return BarForces(byStress.force + changeOfForce, byStress.momentA + momentA,
                   byStress.momentB + momentB);
}
