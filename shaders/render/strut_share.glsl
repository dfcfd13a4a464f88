// What a strut shows of its share. Before: placeCorner().
layout(binding = kBindingShares) uniform samplerBuffer shares;

layout(location = 0) flat out float share;

void main() { share = texelFetch(shares, placeCorner().index)[push.direction]; }
