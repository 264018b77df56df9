#version 450 core
// Third of the depth lines' four steps: of the lines that begin in a pixel's row, the one that reaches farthest beyond it.
// The square of a distance is a sum over rows and columns, so that two steps find what is nearest in the whole picture.
#include "filter.glsl"
#include "depth_lines.glsl"

uniform sampler2D begins;
uniform float width_px;

layout(location = 0) out vec4 best;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int reach = int(ceil(width_px)) + 1;  // see depth_gaps.frag
  best = NO_BEGIN;
  for (int x = -reach; x <= reach; ++x) {
    ivec2 from = pixel + ivec2(x, 0);
    vec4 begin = is_in_picture(from) ? texelFetch(begins, from, 0) : NO_BEGIN;
    begin.x -= float(x * x);
    if (begin.x > best.x) best = begin;
  }
}
