#version 450 core
// Takes the pattern of 4 x 4 out of what light_reach.frag found, over pixels of the same branch that lie in the same
// surface: by depth, normal and place, so that a dark cavity does not spread over its rim.

#include "branches.glsl"

uniform sampler2D surface_texture;
uniform sampler2D reach_texture;
uniform int supersampling;
uniform float pixel_size;     // perspective: mm a pixel per mm of distance, orthographic: mm a pixel
uniform bool is_perspective;

layout(location = 0) out vec2 reach;

vec4 surface_at(ivec2 pixel) {
  vec4 surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  for (int i = 0; i < supersampling * supersampling && !holds(surface); ++i)
    surface = texelFetch(surface_texture, pixel * supersampling + ivec2(i % supersampling, i / supersampling), 0);
  return surface;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  reach = texelFetch(reach_texture, pixel, 0).rg;
  vec4 centre = surface_at(pixel);
  if (!holds(centre)) return;
  vec3 normal = normal_of(centre);
  float pixel_mm = pixel_size * (is_perspective ? centre.w : 1.0);
  ivec2 last = textureSize(reach_texture, 0) - 1;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = 0; i < 16; ++i) {
    ivec2 at = clamp(pixel + ivec2(i & 3, i >> 2) - 1, ivec2(0), last);
    vec4 surface = surface_at(at);
    float facing = max(dot(normal, normal_of(surface)), 0.0);
    float apart = abs(surface.w - centre.w) / (6.0 * pixel_mm);
    bool fits = holds(surface) && length_of_place(surface) == length_of_place(centre);
    float weight = fits ? facing * facing * exp(-apart * apart) : 0.0;
    sum += weight * texelFetch(reach_texture, at, 0).rg;
    weights += weight;
  }
  if (weights > 0.0) reach = sum / weights;
}
