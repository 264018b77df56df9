#version 450 core
// Second of the depth lines' four steps: a begin that stands alone is noise, where a surface turns away, and no line.
#include "filter.glsl"
#include "depth_lines.glsl"

uniform sampler2D begins;

layout(location = 0) out vec4 begin;

const int OF_A_LINE = 2;  // neighbours, on its two sides

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int others = -1;
  for (int i = 0; i < 9; ++i) {
    ivec2 there = pixel + ivec2(i % 3 - 1, i / 3 - 1);
    others += is_in_picture(there) && texelFetch(begins, there, 0).y > 0.0 ? 1 : 0;
  }
  vec4 here = texelFetch(begins, pixel, 0);
  begin = others >= OF_A_LINE ? here : NO_BEGIN;
}
