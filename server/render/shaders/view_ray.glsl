// The ray of a pixel, in patient space (mm) and in the volume's continuous index space.

uniform vec3 eye_mm;            // perspective: where rays start; orthographic: the middle of the plane they start on
uniform vec3 view_forward;      // unit
uniform vec3 view_right;        // to the right edge: perspective per unit of forward, orthographic in mm
uniform vec3 view_up;           // to the upper edge, likewise
uniform bool is_perspective;
uniform mat3 patient_to_index;  // linear part, index per mm
uniform vec3 eye_index;

struct Ray {
  vec3 origin_mm;     // patient space
  vec3 direction;     // patient space, unit
  vec3 origin_index;
  vec3 index_per_mm;  // direction in index space
};

// From the middle of the picture to the point, in units of view_right and view_up. Row 0 is the upper row.
vec3 offset_in_view(vec2 position_px, vec2 size_px) {
  vec2 unit = position_px / size_px;
  return (2.0 * unit.x - 1.0) * view_right + (1.0 - 2.0 * unit.y) * view_up;
}

vec3 view_direction(vec2 position_px, vec2 size_px) {
  return is_perspective ? normalize(view_forward + offset_in_view(position_px, size_px)) : view_forward;
}

Ray view_ray(vec2 position_px, vec2 size_px) {
  vec3 shift_mm = is_perspective ? vec3(0.0) : offset_in_view(position_px, size_px);
  Ray ray;
  ray.direction = view_direction(position_px, size_px);
  ray.origin_mm = eye_mm + shift_mm;
  ray.origin_index = eye_index + patient_to_index * shift_mm;
  ray.index_per_mm = patient_to_index * ray.direction;
  // An exact zero would make 0 * infinity in the slab test.
  bvec3 tiny = lessThan(abs(ray.index_per_mm), vec3(1e-8));
  ray.index_per_mm = mix(ray.index_per_mm, vec3(1e-8), tiny);
  return ray;
}
