#version 450 core
// Lines where the brightness is below that of its surroundings: the difference of two Gaussians.
// Source: D. Marr, E. Hildreth, "Theory of Edge Detection", Proc. R. Soc. B 207, 1980.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"

uniform sampler2D scales;
uniform float sigma_px;
uniform float tau;
uniform float threshold;
uniform vec3 ink;
uniform float strength;

layout(location = 0) out vec4 filtered;

const float LEAST_FADE = 0.01;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || sigma_px == 0.0) return;
  Scales here = scales_of(texelFetch(scales, pixel, 0));
  float darker = tau * here.wide - here.near - threshold;
  float covered = clamp(darker / max(threshold, LEAST_FADE), 0.0, 1.0);
  filtered.rgb = mix(centre.rgb, ink, strength * covered);
}
