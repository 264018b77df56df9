#version 450 core
// Casts one ray a pixel through both branches at once. Under the cutaway's four-case rule the first surface that the ray
// meets holds the pixel, so the two surface buffers never overlap; under the Magic Lens each branch has the whole ray.

#include "branches.glsl"
#include "pixel_ray.glsl"
#include "all_rays.glsl"
#include "volume_along_rays.glsl"
#include "empty_space.glsl"
#include "bands.glsl"
#include "lens.glsl"
#include "funnel.glsl"
#include "lens_cut.glsl"
#include "surface_search.glsl"

layout(location = 0) out vec4 context_surface;
layout(location = 1) out vec4 focus_surface;

vec4 surface_of(Hit hit, float reason, bool behind_lens) {
  float place = 1.0 + (hit.is_cut ? CUT_FACE_LENGTH : 0.0) + (behind_lens ? BEHIND_LENS_LENGTH : 0.0);
  return hit.distance_mm == NO_HIT ? vec4(0.0, 0.0, 0.0, reason) : vec4(place * hit.normal, hit.distance_mm);
}

void cast_cutaway(Ray ray, vec2 volume_mm) {
  Course course = course_of(ray, volume_mm);
  Hit hit = search_surface(ray, course, BEFORE_LENS, BEHIND_LENS);
  bool is_hit = hit.distance_mm != NO_HIT;
  bool is_focus = is_hit && hit.branch == FOCUS;
  bool reaches_lens = !is_hit || hit.distance_mm >= course.lens_mm.y;
  float reason = focus_reason(ray, course, reaches_lens && !is_focus, is_hit);
  bool is_taken = is_context_in_lens(ray, course, !is_hit);
  vec4 surface = surface_of(hit, is_taken ? REASON_OTHER_BRANCH : REASON_LEFT_VOLUME,
                            is_behind_lens(course, hit.distance_mm));
  context_surface = is_focus ? vec4(0.0, 0.0, 0.0, REASON_OTHER_BRANCH) : surface;
  focus_surface = is_focus ? surface : vec4(0.0, 0.0, 0.0, reason);
}

void cast_magic(Ray ray, vec2 volume_mm) {
  Course outside = outside_lens(volume_mm);
  context_surface = surface_of(search_surface(ray, outside, BEFORE_LENS, BEFORE_LENS), REASON_LEFT_VOLUME, false);
  bool is_asked = is_under_lens(ray);
  Course inside = is_asked ? inside_lens(volume_mm) : outside;
  vec4 surface = surface_of(search_surface(ray, inside, IN_LENS, IN_LENS), REASON_LEFT_VOLUME, false);
  focus_surface = is_asked ? surface : vec4(0.0, 0.0, 0.0, REASON_OTHER_BRANCH);
}

void cast_context(Ray ray, vec2 volume_mm) {
  Hit hit = search_surface(ray, outside_lens(volume_mm), BEFORE_LENS, BEFORE_LENS);
  context_surface = surface_of(hit, REASON_LEFT_VOLUME, false);
  focus_surface = vec4(0.0, 0.0, 0.0, hit.distance_mm == NO_HIT ? REASON_LEFT_VOLUME : REASON_OTHER_BRANCH);
}

void main() {
  Ray ray = pixel_ray();
  vec2 volume_mm = intersect_volume(ray);
#if LENS_MODE == LENS_CUTAWAY
  cast_cutaway(ray, volume_mm);
#elif LENS_MODE == LENS_MAGIC
  cast_magic(ray, volume_mm);
#else
  cast_context(ray, volume_mm);
#endif
}
