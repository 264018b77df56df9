#version 450 core
// Last step of Canny's edges: the strong ones, in their colour.
#include "filter.glsl"

uniform sampler2D edges;
uniform float sigma_px;
uniform vec3 ink;
uniform float strength;

layout(location = 0) out vec4 filtered;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || sigma_px == 0.0) return;
  bool is_edge = texelFetch(edges, pixel, 0).r == 1.0;
  filtered.rgb = mix(centre.rgb, ink, is_edge ? strength : 0.0);
}
