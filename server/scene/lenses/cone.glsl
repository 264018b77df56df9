// The cone with its apex at z = -1 and a base of radius 1 at z = 1.
#include "unit_body.glsl"

// Where the ray is within the cone's two nappes, of which unit_interval drops the one below the apex: between the roots of
// a quadratic, or beyond one of them where the ray is steeper than the mantle.
vec2 unit_nappe(vec3 origin, vec3 direction) {
  const real FAR = 1e6;
  real radius = 0.5 * (origin.z + 1.0);
  real growth = 0.5 * direction.z;
  real a = direction.x * direction.x + direction.y * direction.y - growth * growth;
  real b = origin.x * direction.x + origin.y * direction.y - radius * growth;
  real c = origin.x * origin.x + origin.y * origin.y - radius * radius;
  real far = FAR / length(direction);
  real nearly_none = 1e-6 * dot(direction, direction);
  if (abs(a) < nearly_none) {  // along the mantle: one root only
    real root = abs(b) < nearly_none ? 0.0 : -0.5 * c / b;
    return b > 0.0 ? vec2(-far, root) : vec2(root, far);
  }
  real discriminant = b * b - a * c;
  if (discriminant <= 0.0 && a > 0.0) return UNIT_MISS;
  real spread = sqrt(max(discriminant, 0.0)) / abs(a);
  real middle = -b / a;
  if (a > 0.0) return vec2(middle - spread, middle + spread);
  return growth > 0.0 ? vec2(middle + spread, far) : vec2(-far, middle - spread);
}

vec2 unit_interval(vec3 origin, vec3 direction) {
  vec2 within = unit_common(unit_nappe(origin, direction), unit_slab(origin.z, direction.z));
  return within.y > within.x ? within : UNIT_MISS;
}

real unit_gauge(vec3 position) {
  return max(position.z, 2.0 * length(vec2(position.x, position.y)) - position.z);
}

vec3 unit_normal(vec3 position) {
  real radius = length(vec2(position.x, position.y));
  if (position.z >= radius || radius == 0.0) return vec3(0.0, 0.0, sign(position.z));
  return vec3(2.0 * position.x / radius, 2.0 * position.y / radius, -1.0);
}

#include "unit_convex.glsl"
