#version 450 core
// A weak edge beside a strong one becomes strong: drawn again and again, strong edges lead on to weak ones.
#include "filter.glsl"

uniform sampler2D edges;

layout(location = 0) out float edge;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float strongest = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 there = pixel + ivec2(i % 3 - 1, i / 3 - 1);
    strongest = max(strongest, is_in_picture(there) ? texelFetch(edges, there, 0).r : 0.0);
  }
  float here = texelFetch(edges, pixel, 0).r;
  edge = here > 0.0 ? max(here, strongest) : 0.0;
}
