#version 450 core
// Sobel edges over the colour channels, and over the coverage for true silhouettes: the coverage is taken as if no lens
// had cut anything away, since the lens' rim is not a line of the anatomy.
// Source: I. Sobel, G. Feldman 1968, in R. Duda, P. Hart, "Pattern Classification and Scene Analysis", 1973.
#include "filter.glsl"

uniform float strength;
uniform int mode;  // 0 darken, 1 brighten, 2 multiply
uniform float gain;  // 1: raw; 1/4: a unit step along an axis gives 1
uniform bool euclidean;

const int DARKEN = 0;
const int BRIGHTEN = 1;

// Colour and silhouette coverage; the centre's colour where the branch has none, so that only the coverage tells.
vec4 neighbour(ivec2 pixel, vec4 centre) {
  ivec2 last = textureSize(colour_texture, 0) - 1;
  pixel = clamp(pixel, ivec2(0), last);
  vec4 colour = texelFetch(colour_texture, pixel, 0);
  return vec4(colour.a > 0.0 ? colour.rgb : centre.rgb, texelFetch(silhouette_texture, pixel, 0).r);
}

// Clamped before it is scaled: the strength is how black a strong line gets, not a gain.
vec4 edges(ivec2 pixel, vec4 centre) {
  vec4 n[9];
  for (int i = 0; i < 9; ++i) n[i] = neighbour(pixel + ivec2(i % 3 - 1, i / 3 - 1), centre);
  vec4 across = (n[2] + 2.0 * n[5] + n[8]) - (n[0] + 2.0 * n[3] + n[6]);
  vec4 down = (n[6] + 2.0 * n[7] + n[8]) - (n[0] + 2.0 * n[1] + n[2]);
  vec4 magnitude = euclidean ? sqrt(across * across + down * down) : abs(across) + abs(down);
  return min(gain * magnitude, vec4(1.0));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || strength == 0.0) return;
  vec4 edge = edges(pixel, centre);
  vec3 lines = max(edge.rgb, vec3(edge.a));
  if (mode == DARKEN) {
    filtered.rgb = centre.rgb - strength * lines;
  } else if (mode == BRIGHTEN) {
    filtered.rgb = centre.rgb + strength * lines;
  } else {
    filtered.rgb = centre.rgb * (1.0 - strength * brightness(lines));
  }
  filtered.rgb = clamp(filtered.rgb, 0.0, 1.0);
}
