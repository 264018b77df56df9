#version 450 core
// Casts rays where a branch lets light through: both branches' layers front to back with one transmittance, so that their
// opacities and what is left for the background add up to one. An opaque branch is met at its surface, as in ray_cast.frag.

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
#include "translucent_band.glsl"
#include "shade.glsl"

layout(location = 0) out vec4 context_surface;
layout(location = 1) out vec4 focus_surface;
layout(location = 2) out vec4 context_colour;  // premultiplied, with the branch's opacity
layout(location = 3) out vec4 focus_colour;

// What a branch adds to the pixel, and its nearest layer.
struct Layers {
  vec4 colour;   // premultiplied
  vec4 surface;  // as in the surface buffers
};

void add_layer(Ray ray, int branch, float distance_mm, vec3 normal, float opacity, inout float transmittance,
               inout Layers layers) {
  float weight = transmittance * opacity;
  layers.colour += weight * vec4(shade(branch, normal, -ray.direction), 1.0);
  transmittance -= weight;
  if (layers.surface.w < 0.0) layers.surface = vec4(normal, distance_mm);
}

void add_opaque(Ray ray, Course course, int part, inout float transmittance, inout Layers layers) {
  Hit hit = search_surface(ray, course, part, part);
  if (hit.distance_mm != NO_HIT) add_layer(ray, hit.branch, hit.distance_mm, hit.normal, 1.0, transmittance, layers);
}

void add_translucent(Ray ray, Course course, Stretch stretch, inout float transmittance, inout Layers layers) {
  BrickRay bricks = brick_ray(ray);
  float near_mm = stretch.begin_mm;
  float near_value = value_along(ray, near_mm);
  float number = sample_after(course, near_mm);
  float before_entry = skip_empty_space ? sample_before_entry(course) : -1.0;
  if (before_entry > number) {
    number = before_entry + 1.0;
    near_mm = min(sample_mm(course, before_entry), stretch.end_mm);
    near_value = value_along(ray, near_mm);
  }
  while (near_mm < stretch.end_mm && transmittance > LEAST_TRANSMITTANCE) {
    float far_mm = min(sample_mm(course, number), stretch.end_mm);
    float far_value = value_along(ray, far_mm);
    vec2 inside = share_in_band(stretch.band, near_value, far_value);
    if (inside.y > inside.x) {
      float length_mm = (inside.y - inside.x) * (far_mm - near_mm);
      float middle_mm = mix(near_mm, far_mm, 0.5 * (inside.x + inside.y));
      vec3 normal = normal_towards_viewer(position_along(ray, middle_mm), ray.direction, true);
      add_layer(ray, stretch.branch, middle_mm, normal, opacity_over(stretch.branch, length_mm), transmittance, layers);
    }
    near_mm = far_mm;
    near_value = far_value;
    ++number;
    float empty_mm = skip_empty_space ? empty_until_mm(stretch.branch, bricks, far_mm) : 0.0;
    if (empty_mm > near_mm) {
      number = max(number, sample_after(course, empty_mm));
      near_mm = min(max(near_mm, sample_mm(course, number - 1.0)), stretch.end_mm);
      near_value = value_along(ray, near_mm);
    }
  }
}

void add_part(Ray ray, Course course, int part, inout float transmittance, inout Layers layers) {
  Stretch stretch = stretch_of(course, part);
  if (is_empty(stretch) || transmittance <= LEAST_TRANSMITTANCE) return;
  if (opacities[stretch.branch] < 1.0) {
    add_translucent(ray, course, stretch, transmittance, layers);
  } else {
    add_opaque(ray, course, part, transmittance, layers);
  }
}

void cast_cutaway(Ray ray, vec2 volume_mm, inout Layers context, inout Layers focus) {
  Course course = course_of(ray, volume_mm);
  float transmittance = 1.0;
  add_part(ray, course, BEFORE_LENS, transmittance, context);
  bool reaches_lens = transmittance > LEAST_TRANSMITTANCE;
  add_part(ray, course, IN_LENS, transmittance, focus);
  add_part(ray, course, BEHIND_LENS, transmittance, context);
  bool meets_context = context.surface.w >= 0.0;
  if (focus.surface.w < 0.0) focus.surface.w = focus_reason(ray, course, reaches_lens, meets_context);
  bool is_taken = focus.surface.w >= 0.0 || is_context_in_lens(ray, course, !meets_context);
  if (is_behind_lens(course, context.surface.w)) context.surface.xyz *= 1.0 + BEHIND_LENS_LENGTH;
  if (!meets_context && is_taken) context.surface.w = REASON_OTHER_BRANCH;
}

void cast_magic(Ray ray, vec2 volume_mm, inout Layers context, inout Layers focus) {
  float transmittance = 1.0;
  add_part(ray, outside_lens(volume_mm), BEFORE_LENS, transmittance, context);
  focus.surface.w = REASON_OTHER_BRANCH;
  if (!is_under_lens(ray)) return;
  focus.surface.w = REASON_LEFT_VOLUME;
  transmittance = 1.0;
  add_part(ray, inside_lens(volume_mm), IN_LENS, transmittance, focus);
}

void main() {
  Layers context = Layers(vec4(0.0), vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME));
  Layers focus = context;
  Ray ray = pixel_ray();
  vec2 volume_mm = intersect_volume(ray);
  if (volume_mm.y > volume_mm.x) {
#if LENS_MODE == LENS_MAGIC
    cast_magic(ray, volume_mm, context, focus);
#else
    cast_cutaway(ray, volume_mm, context, focus);
#endif
  }
  context_surface = context.surface;
  focus_surface = focus.surface;
  context_colour = context.colour;
  focus_colour = focus.colour;
}
