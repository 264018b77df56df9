// What the unit bodies share. A unit body is convex, holds the origin and fills the cube of -1..1; its file is GLSL and
// C++ alike (see unit_body.h), so that what is drawn and what is picked cannot differ. Each defines
//   vec2 unit_interval(vec3 origin, vec3 direction)  parameters at which the ray origin + t * direction enters and leaves;
//                                                    exit <= entry: it misses. The direction need not be of unit length
//   real unit_gauge(vec3 position)                   0 at the origin, 1 on the surface; grows evenly along each line outward
//   vec3 unit_normal(vec3 position)                  the gauge's gradient
//   real unit_offset(vec3 origin, vec3 direction)    the least gauge along the ray
//   real unit_rim(vec3 origin, vec3 direction, vec2 interval, real reach)
//       how much further, in units of t, the body may go on along a ray that passes by `reach` nearer to the middle
// Rays begin beside the origin (dot(origin, direction) is about 0), which keeps small what is squared.

const vec2 UNIT_MISS = vec2(0.0, 0.0);
const real UNIT_PARALLEL = 1e-9;

vec2 unit_common(vec2 a, vec2 b) { return vec2(max(a.x, b.x), min(a.y, b.y)); }

// Where -1 <= origin + t * direction <= 1.
vec2 unit_slab(real origin, real direction) {
  real d = abs(direction) < UNIT_PARALLEL ? UNIT_PARALLEL : direction;
  real a = (-1.0 - origin) / d;
  real b = (1.0 - origin) / d;
  return vec2(min(a, b), max(a, b));
}
