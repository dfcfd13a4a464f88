// Energy and gradient from differences and dot products in double precision.
#version 450
#extension GL_GOOGLE_include_directive : require
#define PRECISE
#include "shared/solver_types.h"
const int kBlockU = int(kSweepBlockU);
const int kBlockV = int(kPreciseSweepBlockV);
#include "solve/gradient.glsl"
