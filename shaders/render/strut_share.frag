// A strut's colour by its share.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/rod.glsl"
#include "shared/share_color.h"

layout(location = 0) flat in float share;

layout(location = 0) out vec4 color;

void main() { color = vec4(shadeRod(shareColor(share)), 1); }
