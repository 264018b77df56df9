#version 450 core
// The corners of the blocks' faces, as the view sees them. Row 0 is the upper row, as for rays (corner_rays.glsl).
#include "view.glsl"
#include "volume.glsl"

uniform vec3 first_centre_mm;  // patient space
uniform int block_cells;
uniform float nearest_mm;      // perspective: what is nearer is cut off
uniform float farthest_mm;     // orthographic: depth of all at the most

layout(location = 0) in uvec4 block_corner;

out vec3 position_mm;

void main() {
  vec3 from_first = min(vec3(block_corner.xyz * uint(block_cells)) * voxel_size, 1.0 - voxel_size);
  position_mm = first_centre_mm + volume_direction * (from_first * volume_size_mm);
  vec3 from_eye = position_mm - eye_mm;
  float depth_mm = dot(from_eye, view_forward);
  vec2 across = vec2(dot(from_eye, view_right) / dot(view_right, view_right),
                     -dot(from_eye, view_up) / dot(view_up, view_up));
  across = (across - tile_centre * (is_perspective ? depth_mm : 1.0)) / tile_scale;
  gl_Position = is_perspective ? vec4(across, depth_mm - 2.0 * nearest_mm, depth_mm)
                               : vec4(across, 2.0 * depth_mm / farthest_mm - 1.0, 1.0);
}
