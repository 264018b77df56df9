#version 450 core
// Turns one branch's surface into colour: a program for each BRANCH, each shading model, whose file and function are
// defined, each number of rays a pixel, of which it averages SUPERSAMPLING^2, and what else there is to do: RELIEF where
// light is kept away, WALL where the cavity's wall has a tone of its own.

#include "branches.glsl"
#include "light.glsl"
#include "pixel_ray.glsl"
#include SHADING_FILE
#if RELIEF
#include "relief.glsl"
#endif
#if WALL
#include "view.glsl"
#include "volume.glsl"
#include "wall.glsl"
#endif

uniform sampler2D surface_texture;

layout(location = 0) out vec4 shaded;               // display-encoded colour, not premultiplied; coverage
layout(location = 1) out float silhouette_coverage;  // coverage as if no lens had taken anything away

// The ray through a part of the pixel.
vec2 place_of(ivec2 part) { return gl_FragCoord.xy + (vec2(part) + 0.5) / float(SUPERSAMPLING) - 0.5; }
vec3 to_viewer(ivec2 part) { return -normalize(toward_mm(in_picture(place_of(part)))); }

vec3 colour_of(vec4 surface, ivec2 part) {
#if RELIEF
  vec2 reach = reach_at(ivec2(gl_FragCoord.xy));
  float lit = lit_share(reach);
#else
  const float lit = 1.0;
#endif
  vec3 colour = SHADE(BRANCH, normal_of(surface), to_viewer(part), lit);
#if WALL
  colour = wall_of(colour, surface, ray_through(place_of(part)));
#endif
#if RELIEF
  colour = occluded(colour, reach);
#endif
  return colour;
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * SUPERSAMPLING;
  vec3 colour_sum = vec3(0.0);
  float held = 0.0;
  float taken_by_lens = 0.0;
  for (int y = 0; y < SUPERSAMPLING; ++y) {
    for (int x = 0; x < SUPERSAMPLING; ++x) {
      vec4 surface = texelFetch(surface_texture, first + ivec2(x, y), 0);
      vec3 colour = colour_of(surface, ivec2(x, y));
      colour_sum += holds(surface) ? colour : vec3(0.0);
      held += holds(surface) ? 1.0 : 0.0;
      taken_by_lens += surface.w == REASON_OTHER_BRANCH ? 1.0 : 0.0;
    }
  }
  float samples = float(SUPERSAMPLING * SUPERSAMPLING);
  shaded = vec4(colour_sum / max(held, 1.0), held / samples);
  silhouette_coverage = (held + taken_by_lens) / samples;
}
