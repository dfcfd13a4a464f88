// A strut in the colour of its strain. Before: shade().
#include "shared/strain_color.h"

layout(location = 0) flat in float strain;
layout(location = 6) in float behind;

layout(location = 0) out vec4 color;

const float kFarthestLayer = 0.6;  // Brightness: layers behind recede.

void main() { color = vec4(shade(strainColor(strain)) * mix(1, kFarthestLayer, behind), 1); }
