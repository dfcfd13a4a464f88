// A tube's colour by its strain.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/tube_light.glsl"
#include "render/strain_paint.glsl"
