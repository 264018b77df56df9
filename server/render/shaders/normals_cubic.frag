#version 450 core
// Takes a branch's hits and normals anew, of the volume's cubic B-spline: what is linear between voxels draws rings on coarse
// slices. Where a scale is asked for the spline's slope is averaged over TAPS places around the hit, on a copy of the volume
// that is almost so wide itself.

#include "branches.glsl"
#include "pixel_ray.glsl"
#include "volume.glsl"
#include "coarse_volume.glsl"
#include "spline.glsl"

uniform sampler2D surface_texture;
uniform vec2 band;  // stored units
uniform vec3 tap_offset[TAPS];
uniform float tap_weight[TAPS];
uniform mat3 patient_from_slope;  // slopes per texel into gradients, patient space, per mm

layout(location = 0) out vec4 calmed;

// By Newton's method along the ray, no further than half a voxel: the spline's surface lies within that of the linear one.
// Of the places that were tried the best: at an outline there may be no root.
float refined_mm(Ray ray, float hit_mm) {
  float met = stored_value(ray.origin + hit_mm * ray.volume_per_mm);
  float limit = abs(met - band.x) < abs(met - band.y) ? band.x : band.y;
  vec3 voxels_per_mm = ray.volume_per_mm / voxel_size;
  float most_mm = 0.5 / length(voxels_per_mm);
  float moved_mm = 0.0;
  float best_mm = 0.0;
  float best_gap = 1e30;
  for (int i = 0; i < 3; ++i) {
    Spline here = spline_at(volume_texture, vec3(1.0), ray.origin + (hit_mm + moved_mm) * ray.volume_per_mm);
    float gap = here.value - limit;
    if (abs(gap) < best_gap) {
      best_gap = abs(gap);
      best_mm = moved_mm;
    }
    float climb = dot(here.slope, voxels_per_mm);
    moved_mm = clamp(moved_mm - (abs(climb) > 1e-12 ? gap / climb : 0.0), -most_mm, most_mm);
  }
  return max(hit_mm + best_mm, 0.0);
}

vec3 gradient_at(vec3 position) {
  vec3 slope = vec3(0.0);
  for (int i = 0; i < TAPS; ++i)
    slope += tap_weight[i] * spline_at(coarse_texture, coarse_from_volume, position + tap_offset[i]).slope;
  return patient_from_slope * slope;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(surface_texture, texel, 0);
  calmed = surface;
  if (!holds(surface) || is_cut_face(surface)) return;
  Ray ray = pixel_ray();
  calmed.w = refined_mm(ray, surface.w);
  vec3 gradient = gradient_at(ray.origin + calmed.w * ray.volume_per_mm);
  float steepness = length(gradient);
  if (steepness < 1e-12) return;
  // On the side that neighbouring voxels tell: see normals.frag.
  vec3 normal = -gradient / steepness;
  calmed.xyz = length_of_place(surface) * (dot(normal, surface.xyz) < 0.0 ? -normal : normal);
}
