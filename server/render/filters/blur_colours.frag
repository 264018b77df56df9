#version 450 core
// The branch's colours, each multiplied by its coverage, blurred in one direction: the first of two steps.
#include "filter.glsl"
#include "blur.glsl"

layout(location = 0) out vec4 blurred;

vec4 weighed_at(ivec2 pixel) {
  vec4 colour = is_in_picture(pixel) ? texelFetch(colour_texture, pixel, 0) : vec4(0.0);
  return colour.a * vec4(colour.rgb, 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = weighed_at(pixel);
  for (int i = 1; i <= blur_reach(sigma_px); ++i)
    sum += blur_weight(i, sigma_px) * (weighed_at(pixel - i * along) + weighed_at(pixel + i * along));
  blurred = sum / blur_sum(sigma_px);
}
