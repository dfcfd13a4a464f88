// A ribbon's colour by its share.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/ribbon_light.glsl"
#include "render/share_paint.glsl"
