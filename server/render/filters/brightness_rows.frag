#version 450 core
// First step of filters over brightness.glsl: sums along rows.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"

uniform float sigma_px;

layout(location = 0) out vec4 sums;  // narrow: brightness by weight, weights; wide: the same

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float side = side_of(pixel);
  int reach = wide_reach(sigma_px);
  sums = vec4(0.0);
  for (int x = max(-reach, -pixel.x); x <= min(reach, textureSize(colour_texture, 0).x - 1 - pixel.x); ++x) {
    ivec2 there = pixel + ivec2(x, 0);
    vec4 colour = texelFetch(colour_texture, there, 0);
    float weight = side_of(there) == side ? colour.a : 0.0;
    vec2 both = weight * vec2(gaussian(float(x), sigma_px), gaussian(float(x), WIDER * sigma_px));
    sums += both.xxyy * vec2(brightness(colour.rgb), 1.0).xyxy;
  }
}
