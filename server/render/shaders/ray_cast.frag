#version 450 core
// Casts one ray a pixel through both branches at once, by the four-case rule of the cutaway: outside of the lens only the
// context's surface exists, inside only the focus'. The first of them that the ray meets holds the pixel, so the two
// surface buffers never overlap.

#include "branches.glsl"
#include "view_ray.glsl"
#include "volume.glsl"
#include "empty_space.glsl"
#include "surface_search.glsl"
#include LENS_SHAPE

uniform ivec2 surface_size_px;
uniform bool lens_enabled;
uniform bool flat_caps;   // material cut by the lens shows a face of the lens; else the gradient's normal
uniform bool open_caps;   // material cut by the lens shows nothing: its surface must be entered

layout(location = 0) out vec4 context_surface;
layout(location = 1) out vec4 focus_surface;

struct Hit {
  int branch;
  float distance_mm;  // NO_HIT where the stretch holds no surface
  vec3 normal;
};

// The face of the volume's box through which the ray came in: tissue that the box cuts gets a flat face.
vec3 box_face(Ray ray, float distance_mm) {
  vec3 index = ray.origin_index + distance_mm * ray.index_per_mm;
  vec3 to_face = min(abs(index), abs(last_index() - index));
  vec3 face = vec3(lessThanEqual(to_face, min(to_face.yzx, to_face.zxy)));
  return normalize(volume_direction * (face * -sign(ray.index_per_mm)));
}

// `face` is the normal of the cut where the stretch starts in material; zero: the gradient's.
Hit search_stretch(Ray ray, Stretch stretch, vec3 face) {
  Hit hit = Hit(stretch.branch, search_surface(ray, stretch), face);
  if (hit.distance_mm == NO_HIT) return hit;
  bool is_cut = hit.distance_mm == stretch.begin_mm && face != vec3(0.0);
  vec3 index = ray.origin_index + hit.distance_mm * ray.index_per_mm;
  if (!is_cut) hit.normal = normal_towards_viewer(index, ray.direction);
  return hit;
}

// The face that the lens cuts into material at a distance along the ray, seen from the viewer's side.
vec3 lens_face(Ray ray, float distance_mm) {
  if (!flat_caps) return vec3(0.0);
  vec3 normal = lens_normal(ray.origin_mm + distance_mm * ray.direction);
  return faceforward(normal, ray.direction, normal);
}

// The part of the ray in front of the lens, the part inside and the part behind it, in order; each is searched for its
// branch only, and the first hit ends it. An eye inside of the volume sees no cut where it stands.
Hit first_hit(Ray ray, vec2 volume_mm, vec2 lens_mm) {
  bool starts_in_volume = volume_mm.x == 0.0;
  bool crosses = lens_mm.y > lens_mm.x;
  float front_end_mm = crosses ? lens_mm.x : volume_mm.y;
  Hit hit = Hit(CONTEXT, NO_HIT, vec3(0.0));
  if (front_end_mm > volume_mm.x) {
    Stretch front = Stretch(CONTEXT, volume_mm.x, front_end_mm, volume_mm.x, starts_in_volume);
    hit = search_stretch(ray, front, box_face(ray, volume_mm.x));
  }
  if (!crosses || hit.distance_mm != NO_HIT) return hit;
  bool enters_at_box = lens_mm.x <= volume_mm.x;
  bool inside_starts_open = enters_at_box ? starts_in_volume : open_caps;
  Stretch inside = Stretch(FOCUS, lens_mm.x, lens_mm.y, volume_mm.x, inside_starts_open);
  hit = search_stretch(ray, inside, enters_at_box ? box_face(ray, lens_mm.x) : lens_face(ray, lens_mm.x));
  if (hit.distance_mm != NO_HIT || lens_mm.y >= volume_mm.y) return hit;
  Stretch behind = Stretch(CONTEXT, lens_mm.y, volume_mm.y, volume_mm.x, open_caps);
  return search_stretch(ray, behind, lens_face(ray, lens_mm.y));
}

// The lens' interval within the volume's; empty (0,0) where it is off, missed or behind the eye.
vec2 lens_within(Ray ray, vec2 volume_mm) {
  if (!lens_enabled) return vec2(0.0);
  vec2 lens_mm = lens_interval(ray.origin_mm, ray.direction);
  vec2 within = vec2(max(lens_mm.x, volume_mm.x), min(lens_mm.y, volume_mm.y));
  return within.y > within.x ? within : vec2(0.0);
}

void main() {
  context_surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  focus_surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  Ray ray = view_ray(gl_FragCoord.xy, vec2(surface_size_px));
  vec2 volume_mm = intersect_volume(ray.origin_index, ray.index_per_mm);
  if (volume_mm.y <= volume_mm.x) return;
  vec2 lens_mm = lens_within(ray, volume_mm);
  Hit hit = first_hit(ray, volume_mm, lens_mm);
  bool crossed_lens = lens_mm.y > lens_mm.x && (hit.distance_mm == NO_HIT || hit.distance_mm >= lens_mm.y);
  if (crossed_lens) focus_surface.w = REASON_LEFT_LENS;
  if (hit.distance_mm == NO_HIT) return;
  vec4 surface = vec4(hit.normal, hit.distance_mm);
  if (hit.branch == FOCUS) {
    focus_surface = surface;
    context_surface.w = REASON_OTHER_BRANCH;
  } else {
    context_surface = surface;
    if (!crossed_lens) focus_surface.w = REASON_OTHER_BRANCH;
  }
}
