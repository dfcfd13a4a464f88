// Energy and gradient of a frame in double precision.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PRECISE
#include "solve/frame_gradient.glsl"
