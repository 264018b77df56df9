#version 450 core
// Second of Kuwahara's three steps: the windows to the right of and below each pixel, from the sums of their rows. See
// kuwahara.frag.
#include "filter.glsl"
#include "kuwahara.glsl"

uniform sampler2D colour_sums;
uniform sampler2D square_sums;

layout(location = 0) out vec4 window;  // mean colour; unevenness

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy);
  int rows = min(radius_px, textureSize(colour_texture, 0).y + radius_px - 1 - first.y);
  vec4 colour_sum = vec4(0.0);
  float square_sum = 0.0;
  for (int y = 0; y <= rows; ++y) {
    colour_sum += texelFetch(colour_sums, first + ivec2(0, y), 0);
    square_sum += texelFetch(square_sums, first + ivec2(0, y), 0).r;
  }
  float weight = max(colour_sum.a, 1e-9);
  vec3 mean = colour_sum.rgb / weight;
  float offset = offset_of(mean);
  window = vec4(mean, unevenness(max(square_sum / weight - offset * offset, 0.0), colour_sum.a));
}
