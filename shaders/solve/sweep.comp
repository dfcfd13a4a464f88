// The sweep in single precision: the bulk of the work.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "solve/sweep.glsl"
