// The unit ball: spheres and ellipsoids.
#include "unit_body.glsl"

vec2 unit_interval(vec3 origin, vec3 direction) {
  real speed_squared = dot(direction, direction);
  real middle = -dot(origin, direction) / speed_squared;
  vec3 closest = origin + middle * direction;  // numerically kinder than the quadratic's discriminant
  real half_chord_squared = (1.0 - dot(closest, closest)) / speed_squared;
  if (half_chord_squared <= 0.0) return UNIT_MISS;
  real half_chord = sqrt(half_chord_squared);
  return vec2(middle - half_chord, middle + half_chord);
}

real unit_gauge(vec3 position) { return length(position); }

vec3 unit_normal(vec3 position) { return position / length(position); }

real unit_offset(vec3 origin, vec3 direction) {
  return length(origin - dot(origin, direction) / dot(direction, direction) * direction);
}

// Half a chord grows by at most sqrt(half^2 + 2 reach) - half, without bound towards the outline.
// NOLINTNEXTLINE(misc-unused-parameters): other bodies ask where the ray is
real unit_rim(vec3 origin, vec3 direction, vec2 interval, real reach) {
  real speed = length(direction);
  real half_chord = 0.5 * (interval.y - interval.x) * speed;
  return (sqrt(half_chord * half_chord + 2.0 * reach) - half_chord) / speed;
}
