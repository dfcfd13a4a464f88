// A strut as a ribbon that shows a share of its own.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/ribbon.glsl"
#include "render/strut_share.glsl"
