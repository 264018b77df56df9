#version 450 core
// First of the curved strokes' steps: the normals as the camera sees them, and the noise that strokes are made of,
// whose waves go all ways, each two strokes long. See hatching.glsl.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "hatching.glsl"

uniform vec3 view_right;     // of the picture, unit
uniform vec3 view_down;
uniform vec3 view_backward;

layout(location = 0) out vec4 form;    // normal by the three, and 1 where strokes may follow its curvature
layout(location = 1) out vec4 noises;  // of two families; 0; 0

float noise_at(vec2 at, uint family) {
  ivec2 first = ivec2(floor(at));
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 cell = first + ivec2(i & 1, i >> 1);
    vec2 offset = at - vec2(cell);
    uint hash = hash_of(cell, family);
    float way = TURN * share_of(hash >> 20u);
    float phase = dot(offset, vec2(cos(way), sin(way))) + share_of(hash >> 10u);
    sum += window(offset) * height_of(hash) * cos(TURN * phase);
  }
  return sum;
}

vec3 normal_at(ivec2 pixel) {
  vec3 sum = vec3(0.0);
  float met = 0.0;
  for (int i = 0; i < supersampling * supersampling; ++i) {
    vec4 surface = texelFetch(surface_texture, pixel * supersampling + ivec2(i % supersampling, i / supersampling), 0);
    sum += holds(surface) ? normal_of(surface) : vec3(0.0);
    met += holds(surface) ? 1.0 : 0.0;
  }
  return sum / max(met, 1.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 normal = normal_at(pixel);
  bool is_form = normal != vec3(0.0) && side_of(pixel) == 0.0;
  form = is_form ? vec4(dot(normal, view_right), dot(normal, view_down), dot(normal, view_backward), 1.0) : vec4(0.0);
  vec2 at = (gl_FragCoord.xy + first_px) / (2.0 * width_px);
  noises = vec4(noise_at(at, FIRST), noise_at(at, SECOND), 0.0, 0.0);
}
