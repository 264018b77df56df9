// Reading the volume. Values are as stored (0..1 for 16-bit textures): iso-values come converted, so that no sample pays
// for the rescale. Indices are continuous, voxel centres at integers.

uniform sampler3D volume_texture;
uniform ivec3 volume_size;
uniform vec3 volume_spacing_mm;
uniform mat3 volume_direction;  // columns: the i, j, k axes in patient space

float stored_value(vec3 index) {
  return textureLod(volume_texture, (index + 0.5) / vec3(volume_size), 0.0).r;
}

vec3 last_index() { return vec3(volume_size - 1); }

// Slab test against the box of voxel centres. Returns distances (begin, end) in mm, begin >= 0; end < begin: no hit.
vec2 intersect_volume(vec3 origin_index, vec3 index_per_mm) {
  vec3 to_low = -origin_index / index_per_mm;
  vec3 to_high = (last_index() - origin_index) / index_per_mm;
  vec3 near = min(to_low, to_high);
  vec3 far = max(to_low, to_high);
  return vec2(max(max(max(near.x, near.y), near.z), 0.0), min(min(far.x, far.y), far.z));
}

// Central differences over one voxel each way, per millimetre, in patient space; one-sided at the border, where a
// clamped central difference would be half as steep.
// Zero where it is not asked for; a loop, so that nobody's asking costs nothing in software.
vec3 gradient_per_mm(vec3 index, bool is_asked) {
  vec3 gradient = vec3(0.0);
  int axes = is_asked ? 3 : 0;
  for (int axis = 0; axis < axes; ++axis) {
    vec3 step_index = vec3(axis == 0, axis == 1, axis == 2);
    vec3 ahead = min(index + step_index, last_index());
    vec3 behind = max(index - step_index, vec3(0.0));
    float distance_mm = dot((ahead - behind) * volume_spacing_mm, step_index);
    gradient += step_index * (stored_value(ahead) - stored_value(behind)) / max(distance_mm, 1e-6);
  }
  return volume_direction * gradient;
}

// From low to high value, the wrong way for light: the outward normal is its opposite. Flat spots face the viewer.
vec3 normal_towards_viewer(vec3 index, vec3 ray_direction, bool is_asked) {
  vec3 gradient = gradient_per_mm(index, is_asked);
  float steepness = length(gradient);
  vec3 normal = steepness > 1e-12 ? -gradient / steepness : -ray_direction;
  return faceforward(normal, ray_direction, normal);
}
