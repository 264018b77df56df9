#version 450 core
// Ink where the brightness, sharpened by a difference of Gaussians, is below a threshold.
// Source: H. Winnemoeller, J. E. Kyprianidis, S. Olsen, "XDoG", Computers & Graphics 36(6), 2012.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"

uniform sampler2D scales;
uniform float sigma_px;
uniform float edges;
uniform float threshold;
uniform float hardness;
uniform vec3 ink;
uniform float strength;

layout(location = 0) out vec4 filtered;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || sigma_px == 0.0) return;
  Scales here = scales_of(texelFetch(scales, pixel, 0));
  float sharpened = here.near + edges * (here.near - here.wide);
  float covered = tanh(hardness * max(threshold - sharpened, 0.0));
  filtered.rgb = mix(centre.rgb, ink, strength * covered);
}
