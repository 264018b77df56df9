#version 450 core
// Coherent lines: the difference of Gaussians across the picture's flow, smoothed on its way along the flow. The flow is that
// of the brightness' structure tensor, which has no singular points where vectors would cancel.
// Source: H. Kang, S. Lee, C. Chui, "Coherent Line Drawing", NPAR 2007.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "structure_tensor.glsl"

uniform sampler2D tensor;
uniform sampler2D across;
uniform sampler2D scales;
uniform float sigma_px;
uniform float length_px;
uniform float hardness;
uniform vec3 ink;
uniform float strength;

layout(location = 0) out vec4 filtered;

// Sum of the differences on one way along the flow, and of their weights.
vec2 along_flow(ivec2 pixel, vec2 way, float side) {
  vec2 sum = vec2(0.0);
  vec2 at = vec2(pixel);
  for (int i = 1; i <= int(ceil(2.0 * length_px)); ++i) {
    at += way;
    ivec2 there = ivec2(floor(at + 0.5));
    bool is_there = is_in_picture(there) && texelFetch(scales, there, 0).z == side;
    if (!is_there) break;
    vec4 difference = texelFetch(across, there, 0);
    sum += gaussian(float(i), length_px) * difference.xw;
    vec2 next = flow_of(texelFetch(tensor, there, 0)).along;
    way = dot(next, way) < 0.0 ? -next : next;
  }
  return sum;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || sigma_px == 0.0) return;
  vec2 way = flow_of(texelFetch(tensor, pixel, 0)).along;
  float side = texelFetch(scales, pixel, 0).z;
  vec2 sum = texelFetch(across, pixel, 0).xw + along_flow(pixel, way, side) + along_flow(pixel, -way, side);
  float covered = tanh(hardness * max(-sum.x / max(sum.y, 1e-9), 0.0));
  filtered.rgb = mix(centre.rgb, ink, strength * covered);
}
