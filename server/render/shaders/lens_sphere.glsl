// The spherical lens. Every lens shape defines these three functions over these uniforms.

uniform vec3 lens_centre_mm;
uniform float lens_radius_mm;

// Distances (entry, exit) in mm along the ray; exit <= entry: the ray misses the lens.
vec2 lens_interval(vec3 origin_mm, vec3 direction) {
  vec3 from_centre = origin_mm - lens_centre_mm;
  float middle = -dot(from_centre, direction);
  vec3 closest = from_centre + middle * direction;  // numerically kinder than the quadratic's discriminant
  float half_chord_squared = lens_radius_mm * lens_radius_mm - dot(closest, closest);
  if (half_chord_squared <= 0.0) return vec2(0.0);
  float half_chord = sqrt(half_chord_squared);
  return vec2(middle - half_chord, middle + half_chord);
}

// Unit outward normal at a point of the lens' surface.
vec3 lens_normal(vec3 position_mm) { return (position_mm - lens_centre_mm) / lens_radius_mm; }

// How far from the lens' middle a ray passes, in units of its size: 0 through the middle, 1 at the rim, beyond 1 past it;
// a lens behind the eye is passed far away.
float lens_offset(vec3 origin_mm, vec3 direction) {
  vec2 interval_mm = lens_interval(origin_mm, direction);
  if (interval_mm.y <= max(interval_mm.x, 0.0)) return 2.0;
  vec3 to_centre = lens_centre_mm - origin_mm;
  return length(to_centre - dot(to_centre, direction) * direction) / lens_radius_mm;
}
