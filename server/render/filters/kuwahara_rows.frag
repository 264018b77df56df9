#version 450 core
// First of Kuwahara's three steps: sums over the window's width, from each pixel to the right. See kuwahara.frag.
#include "filter.glsl"
#include "kuwahara.glsl"

layout(location = 0) out vec4 colour_sum;  // colours by weight; sum of weights
layout(location = 1) out float square_sum;

void main() {
  ivec2 size = textureSize(colour_texture, 0);
  ivec2 first = ivec2(gl_FragCoord.xy) - radius_px;
  bool is_row = first.y >= 0 && first.y < size.y;
  int begin = is_row ? max(first.x, 0) : 0;
  int end = is_row ? min(first.x + radius_px + 1, size.x) : 0;
  colour_sum = vec4(0.0);
  square_sum = 0.0;
  for (int x = begin; x < end; ++x) {
    vec4 colour = texelFetch(colour_texture, ivec2(x, first.y), 0);
    float offset = offset_of(colour.rgb);
    colour_sum += colour.a * vec4(colour.rgb, 1.0);
    square_sum += colour.a * offset * offset;
  }
}
