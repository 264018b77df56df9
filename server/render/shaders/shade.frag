#version 450 core
// Turns one branch's surface into colour: a program for each BRANCH, each shading model, whose file and function are
// defined, each number of rays a pixel, of which it averages SUPERSAMPLING^2, and what else there is to do: RELIEF where
// light is kept away, WALL where the cavity's wall has a tone of its own, TURNS for models that ask how the normal turns to
// the rays beside.

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

#ifdef TURNS
float ray_spacing_mm(float distance_mm) {
  float at_one = pixel_rays.place.w * length(pixel_rays.up_mm) / float(SUPERSAMPLING);
  return at_one * mix(1.0, distance_mm, pixel_rays.shifts.y);
}

// Of the same surface, as far as neighbours tell: beyond an outline there is another one, whose normal says nothing here.
bool is_beside(vec4 here, vec4 there) { return holds(there) && abs(there.w - here.w) < 4.0 * ray_spacing_mm(here.w); }

vec4 surface_at(ivec2 ray) {
  bool is_cast = all(greaterThanEqual(ray, ivec2(0))) && all(lessThan(ray, textureSize(surface_texture, 0)));
  return is_cast ? texelFetch(surface_texture, ray, 0) : vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
}

// From both sides, or from the one that there is.
vec3 turning_along(ivec2 ray, vec4 here, ivec2 along) {
  vec4 before = surface_at(ray - along);
  vec4 after = surface_at(ray + along);
  float from = is_beside(here, before) ? 1.0 : 0.0;
  float to = is_beside(here, after) ? 1.0 : 0.0;
  vec3 sum = to * (normal_of(after) - normal_of(here)) + from * (normal_of(here) - normal_of(before));
  return sum / max(from + to, 1.0);
}

vec3 shaded_colour(vec4 surface, ivec2 part, float light_share) {
  ivec2 ray = ivec2(gl_FragCoord.xy) * SUPERSAMPLING + part;
  mat2x3 turning = mat2x3(turning_along(ray, surface, ivec2(1, 0)), turning_along(ray, surface, ivec2(0, 1)));
  return SHADE_TURNING(BRANCH, normal_of(surface), to_viewer(part), light_share, turning);
}
#else
vec3 shaded_colour(vec4 surface, ivec2 part, float light_share) {
  return SHADE(BRANCH, normal_of(surface), to_viewer(part), light_share);
}
#endif

vec3 colour_of(vec4 surface, ivec2 part) {
#if RELIEF
  vec2 reach = reach_at(ivec2(gl_FragCoord.xy));
  float light_share = share_of_light(reach);
#else
  const float light_share = 1.0;
#endif
  vec3 colour = shaded_colour(surface, part, light_share);
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
