// A mesh in light grey, lit from both sides.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

layout(push_constant) uniform Push { SamplingPush push; };

layout(location = 0) in vec3 point;
layout(location = 1) flat in vec3 normal;

layout(location = 0) out vec4 color;

const vec3 kGrey = vec3(0.88, 0.88, 0.87);

void main() {
  vec3 towardsEye = normalize(push.eye - point);
  vec3 n = dot(normal, towardsEye) > 0 ? normal : -normal;
  float diffuse = 0.5 + 0.5 * dot(n, push.towardsLight);
  color = vec4(kGrey * (0.42 + 0.62 * diffuse), 1);
}
