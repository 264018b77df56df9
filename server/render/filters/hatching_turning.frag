#version 450 core
// Second: how the normal turns from pixel to pixel, as the products of its derivatives. Where a surface ends nothing
// turns.
#include "filter.glsl"

uniform sampler2D forms;

layout(location = 0) out vec4 turning;  // xx, xy, yy, 1; all 0 where there is no form

const float AN_EDGE = 0.35;  // of the difference's square, about 34 degrees from a pixel to the next

// From `here` to the pixel beside, and whether that is of the same surface.
vec4 turn_to(ivec2 pixel, vec3 here) {
  vec4 there = is_in_picture(pixel) ? texelFetch(forms, pixel, 0) : vec4(0.0);
  vec3 turn = there.xyz - here;
  return there.w > 0.0 && dot(turn, turn) < AN_EDGE ? vec4(turn, 1.0) : vec4(0.0);
}

vec3 turn_along(ivec2 pixel, vec3 here, ivec2 along) {
  vec4 after = turn_to(pixel + along, here);
  vec4 before = turn_to(pixel - along, here);
  return (after.xyz - before.xyz) / max(after.w + before.w, 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(forms, pixel, 0);
  vec3 across = turn_along(pixel, here.xyz, ivec2(1, 0));
  vec3 down = turn_along(pixel, here.xyz, ivec2(0, 1));
  turning = here.w * vec4(dot(across, across), dot(across, down), dot(down, down), 1.0);
}
