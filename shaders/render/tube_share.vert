// A strut as a tube that shows a share of its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/tube.glsl"
#include "render/strut_share.glsl"
