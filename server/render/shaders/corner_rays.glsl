// The vertex shader's side of pixel_ray.glsl: the viewport's triangle, with what the rays of its pixels are made from.
#ifndef HANDED
#define HANDED out
#endif
#include "view.glsl"
#include "viewport_triangle.glsl"
#include "pixel_rays.glsl"

void put_corner() {
  pixel_rays.place = vec4(first_fragment, 2.0 / whole_fragments);
  pixel_rays.shifts = is_perspective ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  pixel_rays.from_mm = eye_mm;
  pixel_rays.toward_mm = view_forward;
  pixel_rays.right_mm = view_right;
  pixel_rays.up_mm = view_up;
  pixel_rays.from_in_volume = eye_in_volume;
  pixel_rays.toward_in_volume = patient_to_volume * view_forward;
  pixel_rays.right_in_volume = patient_to_volume * view_right;
  pixel_rays.up_in_volume = patient_to_volume * view_up;
  gl_Position = behind_everything(viewport_corner());
}
