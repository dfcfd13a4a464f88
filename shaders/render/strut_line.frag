// A line of one colour.
#version 450

layout(location = 0) flat in vec3 lineColor;

layout(location = 0) out vec4 color;

const float kBrightness = 0.85;  // As thin ribbons have it.

void main() { color = vec4(lineColor * kBrightness, 1); }
