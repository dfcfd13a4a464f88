// A strut in the colour of its share. Before: shade().
#include "shared/share_color.h"

layout(location = 0) flat in float share;

layout(location = 0) out vec4 color;

void main() { color = vec4(shade(shareColor(share)), 1); }
