// The cylinder of radius 1 about z, from -1 to 1.
#include "unit_body.glsl"

// Within the cylinder without ends.
vec2 unit_mantle(vec2 origin, vec2 direction) {
  real speed_squared = max(dot(direction, direction), UNIT_PARALLEL * UNIT_PARALLEL);
  real middle = -dot(origin, direction) / speed_squared;
  vec2 closest = origin + middle * direction;
  real half_chord_squared = (1.0 - dot(closest, closest)) / speed_squared;
  if (half_chord_squared <= 0.0) return UNIT_MISS;
  real half_chord = sqrt(half_chord_squared);
  return vec2(middle - half_chord, middle + half_chord);
}

vec2 unit_interval(vec3 origin, vec3 direction) {
  vec2 mantle = unit_mantle(vec2(origin.x, origin.y), vec2(direction.x, direction.y));
  if (mantle.y <= mantle.x) return UNIT_MISS;
  vec2 within = unit_common(mantle, unit_slab(origin.z, direction.z));
  return within.y > within.x ? within : UNIT_MISS;
}

real unit_gauge(vec3 position) { return max(length(vec2(position.x, position.y)), abs(position.z)); }

vec3 unit_normal(vec3 position) {
  real radius = length(vec2(position.x, position.y));
  if (radius < abs(position.z)) return vec3(0.0, 0.0, sign(position.z));
  return vec3(position.x / radius, position.y / radius, 0.0);
}

#include "unit_convex.glsl"
