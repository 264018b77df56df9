#version 450 core
#define HANDED out
#include "corner_rays.glsl"
#include "volume.glsl"
#include "all_rays.glsl"

uniform vec2 lower_limits;          // stored units, by branch
uniform vec2 upper_limits;
uniform float ray_step_mm;
uniform vec3 map_size;              // bricks
uniform vec3 bricks_per_volume;
uniform float first_centre_bricks;

void main() {
  put_corner();
  all_rays.voxel_size = voxel_size;
  all_rays.size_mm = volume_size_mm;
  all_rays.axes = volume_direction;
  all_rays.context_band = vec2(lower_limits.x, upper_limits.x);
  all_rays.focus_band = vec2(lower_limits.y, upper_limits.y);
  all_rays.step_mm = ray_step_mm;
  all_rays.samples_per_mm = 1.0 / ray_step_mm;
  vec3 brick_mm = volume_size_mm / bricks_per_volume;
  all_rays.brick_mm = min(min(brick_mm.x, brick_mm.y), brick_mm.z);
  all_rays.brick_in_map = 1.0 / map_size;
  all_rays.bricks_per_volume = bricks_per_volume;
  all_rays.first_centre_bricks = first_centre_bricks;
}
