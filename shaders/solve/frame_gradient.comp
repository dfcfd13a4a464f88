// Energy and gradient of a frame in single precision.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/frame_gradient.glsl"
