#version 450 core
// Crests of the brightness' slope: first step of Canny's edges after the Gaussian. The slope is measured by what the same
// Gaussian makes of a step, so that thresholds are heights of steps whatever sigma is.
// Source: J. Canny, "A Computational Approach to Edge Detection", IEEE PAMI 8(6), 1986.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "brightness_slope.glsl"

uniform float sigma_px;
uniform float high;
uniform float low;  // as a share of high

layout(location = 0) out float edge;  // 1: strong, 0.5: weak, 0: none

float height_at(ivec2 pixel) {
  pixel = clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1);
  return 2.50662827 * sigma_px * length(brightness_slope(pixel));
}

// Of eight ways, that of the slope.
ivec2 way_of(vec2 slope) {
  const float EIGHTH = 0.414213562;  // the tangent of 22.5 degrees
  vec2 size = abs(slope);
  if (size.y <= EIGHTH * size.x) return ivec2(1, 0);
  if (size.x <= EIGHTH * size.y) return ivec2(0, 1);
  return slope.x * slope.y > 0.0 ? ivec2(1, 1) : ivec2(1, -1);
}

// Of two crests that are equally high the first one is left.
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 way = way_of(brightness_slope(pixel));
  float height = height_at(pixel);
  bool is_crest = height > height_at(pixel - way) && height >= height_at(pixel + way);
  edge = is_crest && height >= high ? 1.0 : is_crest && height >= low * high && height > 0.0 ? 0.5 : 0.0;
}
