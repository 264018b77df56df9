#version 450 core
// Hatching in parallel strokes, crossed where it is dark; see hatching.glsl.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "hatching.glsl"

layout(location = 0) out vec4 filtered;

float surface_strokes(vec2 place, float darkness) {
  vec2 shares = shares_of(darkness, cross_from);
  return both(inked(parallel_strokes(place, angle, FIRST), shares.x),
              inked(parallel_strokes(place, angle + CROSSED_BY, SECOND), shares.y));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || width_px == 0.0) return;
  float darkness = 1.0 - brightness(centre.rgb);
  bool is_wall = side_of(pixel) == 1.0;
  float covered = is_wall ? wall_strokes(gl_FragCoord.xy, darkness) : surface_strokes(gl_FragCoord.xy, darkness);
  filtered.rgb = drawn(centre.rgb, covered);
}
