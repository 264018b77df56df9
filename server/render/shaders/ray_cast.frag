#version 450 core
// Casts one ray a pixel through both branches at once. Under the cutaway's four-case rule the first surface that the ray
// meets holds the pixel, so the two surface buffers never overlap; under the Magic Lens each branch has the whole ray.

#include "branches.glsl"
#include "view_ray.glsl"
#include "volume.glsl"
#include "empty_space.glsl"
#include "surface_search.glsl"
#include LENS_SHAPE
#include "lens_cut.glsl"

uniform ivec2 surface_size_px;

layout(location = 0) out vec4 context_surface;
layout(location = 1) out vec4 focus_surface;

struct Hit {
  int branch;
  float distance_mm;  // NO_HIT where there is no surface
  vec3 normal;
};

Hit search_part(Ray ray, Part part) {
  Hit hit = Hit(part.stretch.branch, search_surface(ray, part.stretch), part.face);
  if (hit.distance_mm == NO_HIT) return hit;
  bool is_cut = hit.distance_mm == part.stretch.begin_mm && part.face != vec3(0.0);
  vec3 index = ray.origin_index + hit.distance_mm * ray.index_per_mm;
  if (!is_cut) hit.normal = normal_towards_viewer(index, ray.direction);
  return hit;
}

vec4 surface_of(Hit hit, float reason) {
  return hit.distance_mm == NO_HIT ? vec4(0.0, 0.0, 0.0, reason) : vec4(hit.normal, hit.distance_mm);
}

void cast_cutaway(Ray ray, vec2 volume_mm) {
  vec2 lens_mm = lens_within(ray, volume_mm);
  Hit hit = Hit(CONTEXT, NO_HIT, vec3(0.0));
  for (int i = 0; i < CUTAWAY_PARTS && hit.distance_mm == NO_HIT; ++i) {
    Part part = cutaway_part(i, ray, volume_mm, lens_mm);
    if (!is_empty(part)) hit = search_part(ray, part);
  }
  bool is_hit = hit.distance_mm != NO_HIT;
  if (is_hit && hit.branch == FOCUS) {
    focus_surface = surface_of(hit, 0.0);
    context_surface.w = REASON_OTHER_BRANCH;
    return;
  }
  context_surface = surface_of(hit, REASON_LEFT_VOLUME);
  bool reaches_lens = !is_hit || hit.distance_mm >= lens_mm.y;
  focus_surface.w = focus_reason(ray, volume_mm, lens_mm, reaches_lens, is_hit);
}

void cast_magic(Ray ray, vec2 volume_mm) {
  context_surface = surface_of(search_part(ray, whole_ray(CONTEXT, ray, volume_mm)), REASON_LEFT_VOLUME);
  focus_surface.w = REASON_OTHER_BRANCH;
  if (!is_under_lens(ray)) return;
  focus_surface = surface_of(search_part(ray, whole_ray(FOCUS, ray, volume_mm)), REASON_LEFT_VOLUME);
}

void main() {
  context_surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  focus_surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  Ray ray = view_ray(gl_FragCoord.xy, vec2(surface_size_px));
  vec2 volume_mm = intersect_volume(ray.origin_index, ray.index_per_mm);
  if (volume_mm.y <= volume_mm.x) return;
  if (lens_mode == LENS_MAGIC) {
    cast_magic(ray, volume_mm);
  } else {
    cast_cutaway(ray, volume_mm);
  }
}
