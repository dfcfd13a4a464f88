// The colour of what a strut shows, see strut_shown.glsl.
#include "shared/render_types.h"
#include "shared/share_color.h"
#include "shared/strain_color.h"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;

layout(location = 0) flat in float shown;
layout(location = 6) in float behind;

layout(location = 0) out vec4 color;

const float kFarthestLayer = 0.6;  // Brightness: layers behind recede.

// shade: of the place on the strut
void paint(float shade) {
  vec3 hue = kShowsShares ? shareColor(shown) : strainColor(shown);
  color = vec4(hue * shade * mix(1, kFarthestLayer, behind), 1);
}
