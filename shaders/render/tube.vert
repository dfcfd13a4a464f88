// A strut as a tube that shows its strain.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/tube.glsl"
#include "render/strut_strain.glsl"
