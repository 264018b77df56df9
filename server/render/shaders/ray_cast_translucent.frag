#version 450 core
// Casts rays where a branch lets light through: both branches' layers front to back with one transmittance, so that their
// opacities and what is left for the background add up to one. An opaque branch is met at its surface, as in ray_cast.frag.

#include "branches.glsl"
#include "view_ray.glsl"
#include "volume.glsl"
#include "empty_space.glsl"
#include "surface_search.glsl"
#include LENS_SHAPE
#include "lens_cut.glsl"
#include "translucent_band.glsl"
#include "shade.glsl"

uniform ivec2 surface_size_px;

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

void add_opaque(Ray ray, Part part, inout float transmittance, inout Layers layers) {
  float distance_mm = search_surface(ray, part.stretch);
  if (distance_mm == NO_HIT) return;
  bool is_cut = distance_mm == part.stretch.begin_mm && part.face != vec3(0.0);
  vec3 index = ray.origin_index + distance_mm * ray.index_per_mm;
  vec3 normal = is_cut ? part.face : normal_towards_viewer(index, ray.direction);
  add_layer(ray, part.stretch.branch, distance_mm, normal, 1.0, transmittance, layers);
}

void add_translucent(Ray ray, Part part, inout float transmittance, inout Layers layers) {
  Stretch stretch = part.stretch;
  float near_mm = stretch.begin_mm;
  float near_value = value_along(ray, near_mm);
  int sample_number = sample_after(stretch, near_mm);
  while (near_mm < stretch.end_mm && transmittance > LEAST_TRANSMITTANCE) {
    float far_mm = min(stretch.lattice_mm + float(sample_number) * step_mm, stretch.end_mm);
    vec3 index = ray.origin_index + far_mm * ray.index_per_mm;
    float far_value = stored_value(index);
    vec2 inside = share_in_band(stretch.branch, near_value, far_value);
    if (inside.y > inside.x) {
      float length_mm = (inside.y - inside.x) * (far_mm - near_mm);
      float middle_mm = mix(near_mm, far_mm, 0.5 * (inside.x + inside.y));
      vec3 normal = normal_towards_viewer(ray.origin_index + middle_mm * ray.index_per_mm, ray.direction);
      add_layer(ray, stretch.branch, middle_mm, normal, opacity_over(stretch.branch, length_mm), transmittance, layers);
    }
    near_mm = far_mm;
    near_value = far_value;
    ++sample_number;
    float empty_mm = skip_empty_space ? empty_until_mm(stretch.branch, index, ray) : 0.0;
    if (empty_mm > near_mm) {
      sample_number = max(sample_number, sample_after(stretch, empty_mm));
      near_mm = min(max(near_mm, stretch.lattice_mm + float(sample_number - 1) * step_mm), stretch.end_mm);
      near_value = value_along(ray, near_mm);
    }
  }
}

void add_part(Ray ray, Part part, inout float transmittance, inout Layers layers) {
  if (is_empty(part) || transmittance <= LEAST_TRANSMITTANCE) return;
  if (opacities[part.stretch.branch] < 1.0) {
    add_translucent(ray, part, transmittance, layers);
  } else {
    add_opaque(ray, part, transmittance, layers);
  }
}

void cast_cutaway(Ray ray, vec2 volume_mm, inout Layers context, inout Layers focus) {
  vec2 lens_mm = lens_within(ray, volume_mm);
  float transmittance = 1.0;
  add_part(ray, cutaway_part(0, ray, volume_mm, lens_mm), transmittance, context);
  bool reaches_lens = transmittance > LEAST_TRANSMITTANCE;
  add_part(ray, cutaway_part(1, ray, volume_mm, lens_mm), transmittance, focus);
  add_part(ray, cutaway_part(2, ray, volume_mm, lens_mm), transmittance, context);
  if (focus.surface.w < 0.0)
    focus.surface.w = focus_reason(ray, volume_mm, lens_mm, reaches_lens, context.surface.w >= 0.0);
  if (context.surface.w < 0.0 && focus.surface.w >= 0.0) context.surface.w = REASON_OTHER_BRANCH;
}

void cast_magic(Ray ray, vec2 volume_mm, inout Layers context, inout Layers focus) {
  float transmittance = 1.0;
  add_part(ray, whole_ray(CONTEXT, ray, volume_mm), transmittance, context);
  focus.surface.w = REASON_OTHER_BRANCH;
  if (!is_under_lens(ray)) return;
  focus.surface.w = REASON_LEFT_VOLUME;
  transmittance = 1.0;
  add_part(ray, whole_ray(FOCUS, ray, volume_mm), transmittance, focus);
}

void main() {
  Layers context = Layers(vec4(0.0), vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME));
  Layers focus = context;
  Ray ray = view_ray(gl_FragCoord.xy, vec2(surface_size_px));
  vec2 volume_mm = intersect_volume(ray.origin_index, ray.index_per_mm);
  if (volume_mm.y > volume_mm.x) {
    if (lens_mode == LENS_MAGIC) {
      cast_magic(ray, volume_mm, context, focus);
    } else {
      cast_cutaway(ray, volume_mm, context, focus);
    }
  }
  context_surface = context.surface;
  focus_surface = focus.surface;
  context_colour = context.colour;
  focus_colour = focus.colour;
}
