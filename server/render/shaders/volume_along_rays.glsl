// What a ray asks of the volume.
#include "volume.glsl"

// The box of voxel centres.
vec3 first_centre() { return 0.5 * all_rays.voxel_size; }
vec3 last_centre() { return 1.0 - 0.5 * all_rays.voxel_size; }

// Slab test against the box of voxel centres. Returns distances (begin, end) in mm, begin >= 0; end < begin: no hit.
vec2 intersect_volume(Ray ray) {
  vec3 to_first = (first_centre() - ray.origin) / ray.volume_per_mm;
  vec3 to_last = (last_centre() - ray.origin) / ray.volume_per_mm;
  vec3 near = min(to_first, to_last);
  vec3 far = max(to_first, to_last);
  return vec2(max(max(max(near.x, near.y), near.z), 0.0), min(min(far.x, far.y), far.z));
}

vec3 position_along(Ray ray, float distance_mm) { return ray.origin + distance_mm * ray.volume_per_mm; }

float value_along(Ray ray, float distance_mm) { return stored_value(position_along(ray, distance_mm)); }

// Central differences over one voxel each way, per millimetre, in patient space; one-sided at the border, where a
// clamped central difference would be half as steep.
// Zero where it is not asked for; a loop, so that nobody's asking costs nothing in software.
vec3 gradient_per_mm(vec3 position, bool is_asked) {
  vec3 ahead = min(position + all_rays.voxel_size, last_centre());
  vec3 behind = max(position - all_rays.voxel_size, first_centre());
  vec3 rise = vec3(0.0);
  for (int once = 0; once < (is_asked ? 1 : 0); ++once) {
    rise.x = stored_value(vec3(ahead.x, position.yz)) - stored_value(vec3(behind.x, position.yz));
    rise.y = stored_value(vec3(position.x, ahead.y, position.z)) - stored_value(vec3(position.x, behind.y, position.z));
    rise.z = stored_value(vec3(position.xy, ahead.z)) - stored_value(vec3(position.xy, behind.z));
  }
  return all_rays.axes * (rise / max((ahead - behind) * all_rays.size_mm, 1e-20));
}

// From low to high value, the wrong way for light: the outward normal is its opposite. Flat spots face the viewer.
vec3 normal_towards_viewer(vec3 position, vec3 ray_direction, bool is_asked) {
  vec3 gradient = gradient_per_mm(position, is_asked);
  float steepness = length(gradient);
  vec3 normal = steepness > 1e-12 ? -gradient / steepness : -ray_direction;
  return faceforward(normal, ray_direction, normal);
}
