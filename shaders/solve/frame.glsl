// Joints and bars of a frame, as the kernels find them (shared/frame_types.h).
#extension GL_EXT_control_flow_attributes : require
#include "energy/beam.glsl"
#include "energy/joint.glsl"
#include "shared/topology.h"

layout(local_size_x_id = kConstantSubgroupSize) in;
layout(constant_id = kConstantIsLoaded) const bool kIsLoaded = false;

layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer joints;
layout(binding = kBindingRest, rgba32i) readonly uniform iimageBuffer restLengths;
layout(binding = kBindingPrinted, rgba32f) readonly uniform imageBuffer printed;
layout(binding = kBindingLoads, rgba32f) readonly uniform imageBuffer loads;
layout(binding = kBindingPrintedPositions, rgba32i) readonly uniform iimageBuffer printedPositions;
layout(push_constant) uniform Push { FramePush push; };

int jointCount() { return push.grid.size.x * push.grid.size.y * push.grid.size.z; }

// Of the nearest joint that there is.
int indexOf(ivec3 vertex) {
  return vertexIndex(push.grid.size, clamp(vertex, ivec3(0), push.grid.size - 1));
}

Joint jointAt(int index) {
  return Joint(imageLoad(joints, index), imageLoad(joints, jointCount() + index));
}

vec3 holdingStiffness() { return vec3(push.holdingAside, push.holdingAside, push.holding); }

// Of a frame that is loaded.
JointTerm jointTermAt(int index, Joint joint) {
  vec4 load = imageLoad(loads, index);
  Real3 moved = armBetween(imageLoad(printedPositions, index), joint.position, push.grid.resolution);
  Real4 q = Real4(joint.rotation) / Real(1 << int(kRotationBits));
  return JointTerm(moved, q.xyz, q.w, Real3(load.xyz), load.w * holdingStiffness(), load.w * push.turning);
}

DeviceBarSection sectionOf(int axis) {
  if (axis == 2) {
    return push.upright;
  }
  return push.lateral;
}

// The bar that leaves `from` along an axis. One that is not there rests.
Beam beamFrom(ivec3 from, int axis, Joint jointA, Joint jointB) {
  int index = indexOf(from);
  float rest = float(imageLoad(restLengths, index)[axis]) * push.grid.restResolution;
  vec4 directions = imageLoad(printed, index);
  vec2 direction = axis == 0 ? directions.xy : directions.zw;
  bool isThere = hasStrut(push.grid.size, from, axis);
  rest = isThere ? rest : 1.0;
  BarEnd a = barEndAt(jointA, direction, axis == 2);
  BarEnd b = barEndAt(jointB, direction, axis == 2);
  Real3 arm = armBetween(jointA.position, jointB.position, push.grid.resolution);
  return beamBetween(a, b, isThere ? arm : Real(rest) * a.t, rest,
                     axis == 2 ? push.uprightJoint : push.lateralJoint);
}
