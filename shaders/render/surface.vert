// The surface of the middle layer.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface.glsl"

void main() { placeVertex(); }
