// What the bars at a joint add up to: forces and moments of the energy's gradient, or of a product of its
// Hessian with a vector z. An invocation walks up a column. An including kernel defines
//   Sum                              the type in which energies are added up
//   barForces(section, beam, z)      what a bar adds
//   barMotion(indexA, indexB)        z at a bar's ends
//   jointForces(term, index)         what acts on a joint from outside
//   finish(index, force, moment)     a joint's sums, complete
#include "solve/frame.glsl"

BarForces barForces(DeviceBarSection section, Beam beam, BarMotion z);
BarMotion barMotion(int indexA, int indexB);
JointForces jointForces(JointTerm term, int index);
void finish(int index, Real3 force, Real3 moment);

Sum energy = Sum(0);  // of the column's joints and the bars that leave them

void addBars(ivec3 vertex, int axis, Joint here, inout Real3 force, inout Real3 moment) {
  DeviceBarSection section = sectionOf(axis);
  ivec3 next = neighbour(vertex, axis, 1), previous = neighbour(vertex, axis, -1);
  int index = indexOf(vertex);

  Beam beam = beamFrom(vertex, axis, here, jointAt(indexOf(next)));
  BarForces forces = barForces(section, beam, barMotion(index, indexOf(next)));
  Real share = hasStrut(push.grid.size, vertex, axis) ? Real(1) : Real(0);
  force -= share * forces.force;
  moment += share * forces.momentA;
  energy += Sum(share * beamEnergy(section, beam));

  beam = beamFrom(previous, axis, jointAt(indexOf(previous)), here);
  forces = barForces(section, beam, barMotion(indexOf(previous), index));
  share = hasStrut(push.grid.size, previous, axis) ? Real(1) : Real(0);
  force += share * forces.force;
  moment += share * forces.momentB;
}

void addLoad(int index, Joint here, inout Real3 force, inout Real3 moment) {
  JointTerm term = jointTermAt(index, here);
  JointForces forces = jointForces(term, index);
  force += forces.force;
  moment += forces.moment;
  energy += Sum(jointEnergy(term));
}

void walkColumn() {
  ivec2 column = ivec2(gl_GlobalInvocationID.xy);
  if (!hasColumn(push.grid.size, column)) {
    return;
  }
  for (int layer = 0; layer < push.grid.size.z; ++layer) {
    ivec3 vertex = ivec3(column, layer);
    int index = indexOf(vertex);
    Joint here = jointAt(index);
    Real3 force = Real3(0), moment = Real3(0);
    addBars(vertex, 0, here, force, moment);
    addBars(vertex, 1, here, force, moment);
    addBars(vertex, 2, here, force, moment);
    if (kIsLoaded) {
      addLoad(index, here, force, moment);
    }
    finish(index, force, moment);
  }
}
