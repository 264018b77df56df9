#version 450 core
// What a step before left, blurred in one direction.
#include "filter.glsl"
#include "blur.glsl"

uniform sampler2D unblurred;  // multiplied by weights, which are in alpha

layout(location = 0) out vec4 blurred;

vec4 weighed_at(ivec2 pixel) { return is_in_picture(pixel) ? texelFetch(unblurred, pixel, 0) : vec4(0.0); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = weighed_at(pixel);
  for (int i = 1; i <= blur_reach(sigma_px); ++i)
    sum += blur_weight(i, sigma_px) * (weighed_at(pixel - i * along) + weighed_at(pixel + i * along));
  blurred = sum / blur_sum(sigma_px);
}
