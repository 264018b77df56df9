#version 450 core
// The difference of two Gaussians across the picture's flow: a step of the coherent lines. See fdog.frag.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "structure_tensor.glsl"

uniform sampler2D tensor;
uniform sampler2D scales;  // for sides and coverage
uniform float sigma_px;
uniform float tau;

layout(location = 0) out vec4 difference;  // times its weight; 0; 0; weight

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Flow flow = flow_of(texelFetch(tensor, pixel, 0));
  Scales here = scales_of(texelFetch(scales, pixel, 0));
  vec2 across = vec2(-flow.along.y, flow.along.x);
  int reach = wide_reach(sigma_px);
  vec4 sums = vec4(0.0);
  for (int i = -reach; i <= reach; ++i) {
    ivec2 there = pixel + ivec2(floor(float(i) * across + 0.5));
    if (!is_in_picture(there)) continue;
    vec4 colour = texelFetch(colour_texture, there, 0);
    float weight = texelFetch(scales, there, 0).z == here.side ? colour.a : 0.0;
    vec2 both = weight * vec2(gaussian(float(i), sigma_px), gaussian(float(i), WIDER * sigma_px));
    sums += both.xxyy * vec2(brightness(colour.rgb), 1.0).xyxy;
  }
  float value = sums.x / max(sums.y, 1e-9) - tau * sums.z / max(sums.w, 1e-9);
  difference = here.is_covered ? vec4(value, 0.0, 0.0, 1.0) : vec4(0.0);
}
