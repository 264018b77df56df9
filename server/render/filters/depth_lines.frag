#version 450 core
// Last of the depth lines' four steps: the lines in their colour, on the nearer side of each gap.
// Source for lines by depth: T. Saito, T. Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990.
#include "branches.glsl"
#include "filter.glsl"
#include "depth_lines.glsl"

uniform sampler2D rows;
uniform float width_px;
uniform vec3 ink;
uniform float strength;

layout(location = 0) out vec4 filtered;

float nearest_mm(ivec2 pixel) {
  float nearest = 1e9;
  for (int i = 0; i < supersampling * supersampling; ++i) {
    vec4 surface = texelFetch(surface_texture, pixel * supersampling + ivec2(i % supersampling, i / supersampling), 0);
    nearest = min(nearest, holds(surface) ? surface.w : 1e9);
  }
  return nearest;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || width_px == 0.0) return;
  int reach = int(ceil(width_px)) + 1;
  Begin best = begin_of(NO_BEGIN);
  for (int y = -reach; y <= reach; ++y) {
    ivec2 from = pixel + ivec2(0, y);
    Begin begin = begin_of(is_in_picture(from) ? texelFetch(rows, from, 0) : NO_BEGIN);
    begin.reach_sq -= float(y * y);
    if (begin.reach_sq > best.reach_sq) best = begin;
  }
  float distance_px = sqrt(max(best.width_px * best.width_px - best.reach_sq, 0.0));
  float covered = best.reach_sq > 0.0 ? clamp(best.width_px - distance_px, 0.0, 1.0) : 0.0;
  covered *= nearest_mm(pixel) < best.behind_mm ? strength : 0.0;
  filtered.rgb = mix(centre.rgb, ink, covered);
}
