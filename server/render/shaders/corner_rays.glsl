// The vertex shader's side of pixel_ray.glsl: the viewport's triangle, with the rays of its pixels. They change linearly from
// pixel to pixel, and a software rasteriser interpolates for less than it reads uniforms.
#include "view.glsl"
#include "viewport_triangle.glsl"

noperspective out vec3 from_mm;
noperspective out vec3 toward_mm;  // not of unit length
noperspective out vec3 from_in_volume;
noperspective out vec3 toward_in_volume;

// Row 0 of the picture is the upper row, and the lower one of the viewport.
void put_corner() {
  vec2 corner = viewport_corner();
  vec2 in_picture = tile_centre + tile_scale * corner;
  vec3 across = in_picture.x * view_right - in_picture.y * view_up;
  vec3 shift_mm = is_perspective ? vec3(0.0) : across;
  from_mm = eye_mm + shift_mm;
  toward_mm = view_forward + (is_perspective ? across : vec3(0.0));
  from_in_volume = eye_in_volume + patient_to_volume * shift_mm;
  toward_in_volume = patient_to_volume * toward_mm;
  gl_Position = behind_everything(corner);
}
