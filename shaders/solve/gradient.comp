// Energy and gradient in single precision.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/solver_types.h"
const int kBlockU = int(kSweepBlockU);
const int kBlockV = int(kSweepBlockV);
#include "solve/gradient.glsl"
