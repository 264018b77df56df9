#version 450 core
// First of Kuwahara's three steps: sums over the window's width, from each pixel to the right. See filter_kuwahara.frag.
#include "filter.glsl"
#include "kuwahara.glsl"

layout(location = 0) out vec4 colour_sum;  // colours by weight; sum of weights
layout(location = 1) out float square_sum;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) - radius_px;
  ivec2 last = textureSize(colour_texture, 0) - 1;
  colour_sum = vec4(0.0);
  square_sum = 0.0;
  for (int x = 0; x <= radius_px; ++x) {
    ivec2 pixel = first + ivec2(x, 0);
    vec4 colour = texelFetch(colour_texture, clamp(pixel, ivec2(0), last), 0);
    float weight = is_in_picture(pixel) ? colour.a : 0.0;
    float offset = offset_of(colour.rgb);
    colour_sum += weight * vec4(colour.rgb, 1.0);
    square_sum += weight * offset * offset;
  }
}
