// The cube of -1..1: boxes.
#include "unit_body.glsl"

vec2 unit_interval(vec3 origin, vec3 direction) {
  vec2 sides = unit_common(unit_slab(origin.x, direction.x), unit_slab(origin.y, direction.y));
  vec2 within = unit_common(sides, unit_slab(origin.z, direction.z));
  return within.y > within.x ? within : UNIT_MISS;
}

real unit_gauge(vec3 position) { return max(max(abs(position.x), abs(position.y)), abs(position.z)); }

vec3 unit_normal(vec3 position) {
  vec3 size = abs(position);
  if (size.x >= size.y && size.x >= size.z) return vec3(sign(position.x), 0.0, 0.0);
  if (size.y >= size.z) return vec3(0.0, sign(position.y), 0.0);
  return vec3(0.0, 0.0, sign(position.z));
}

#include "unit_convex.glsl"
