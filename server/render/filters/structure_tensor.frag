#version 450 core
// Products of a picture's derivatives, summed over its colours: which way it changes most and, once smoothed, how much it
// agrees on that. The outline is no change: where the branch has nothing, its middle goes on.
#include "filter.glsl"

uniform sampler2D blurred;  // colours multiplied by their weight

layout(location = 0) out vec4 tensor;  // xx, xy, yy, 1; all 0 where the branch has nothing

vec3 colour_at(ivec2 pixel, vec3 middle) {
  pixel = clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1);
  vec4 colour = texelFetch(blurred, pixel, 0);
  bool is_covered = texelFetch(colour_texture, pixel, 0).a > 0.0;
  return is_covered ? colour.rgb / max(colour.a, 1e-6) : middle;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(blurred, pixel, 0);
  vec3 middle = here.rgb / max(here.a, 1e-6);
  vec3 n[9];
  for (int i = 0; i < 9; ++i) n[i] = colour_at(pixel + ivec2(i % 3 - 1, i / 3 - 1), middle);
  vec3 across = 0.25 * ((n[2] + 2.0 * n[5] + n[8]) - (n[0] + 2.0 * n[3] + n[6]));
  vec3 down = 0.25 * ((n[6] + 2.0 * n[7] + n[8]) - (n[0] + 2.0 * n[1] + n[2]));
  float is_covered = texelFetch(colour_texture, pixel, 0).a > 0.0 ? 1.0 : 0.0;
  tensor = is_covered * vec4(dot(across, across), dot(across, down), dot(down, down), 1.0);
}
