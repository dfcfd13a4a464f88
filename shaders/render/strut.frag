// A strut's colour by its strain.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/rod.glsl"
#include "shared/strain_color.h"

layout(location = 0) flat in float strain;
layout(location = 6) in float behind;

layout(location = 0) out vec4 color;

const float kFarthestLayer = 0.6;  // Brightness: layers behind recede.

void main() {
  color = vec4(shadeRod(strainColor(strain)) * mix(1, kFarthestLayer, behind), 1);
}
