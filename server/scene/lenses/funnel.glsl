// The way that a cutaway opens towards the eye; see funnel.h. Without one its radius is 0.

uniform vec3 funnel_foot_mm;
uniform vec3 funnel_axis;  // unit, towards the eye
uniform float funnel_radius_mm;
uniform float funnel_widening;  // mm per mm of height

bool is_in_funnel(vec3 position_mm) {
  vec3 from_foot = position_mm - funnel_foot_mm;
  float height = dot(from_foot, funnel_axis);
  float reach = funnel_radius_mm + height * funnel_widening;
  return funnel_radius_mm > 0.0 && height >= 0.0 &&
         dot(from_foot, from_foot) - height * height <= reach * reach;
}

// The smallest root above 0 of a t^2 + 2 b t + c, which is below 0 at t = 0.
float first_root(float a, float b, float c) {
  const float NONE = 1e9;
  if (abs(a) < 1e-6) return b > 0.0 ? -c / (2.0 * b) : NONE;
  float discriminant = b * b - a * c;
  if (discriminant < 0.0) return NONE;
  float half_sum = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
  float one = half_sum / a;
  float other = half_sum != 0.0 ? c / half_sum : NONE;
  float smaller = min(one, other);
  float larger = max(one, other);
  return smaller > 0.0 ? smaller : larger > 0.0 ? larger : NONE;
}

// How far a ray that begins in the funnel stays there; 0 for one that does not.
float funnel_exit_mm(vec3 origin_mm, vec3 direction) {
  vec3 from_foot = origin_mm - funnel_foot_mm;
  float height = dot(from_foot, funnel_axis);
  float climb = dot(direction, funnel_axis);
  float reach = funnel_radius_mm + height * funnel_widening;
  vec3 across = from_foot - height * funnel_axis;
  float c = dot(across, across) - reach * reach;
  if (funnel_radius_mm <= 0.0 || height <= 0.0 || reach <= 0.0 || c >= 0.0) return 0.0;
  float a = 1.0 - climb * climb * (1.0 + funnel_widening * funnel_widening);
  float b = dot(across, direction) - reach * climb * funnel_widening;
  return min(first_root(a, b, c), climb < 0.0 ? -height / climb : 1e9);
}

// Outward, unit, of its side or its foot where the ray leaves it.
vec3 funnel_normal(vec3 position_mm) {
  vec3 from_foot = position_mm - funnel_foot_mm;
  float height = dot(from_foot, funnel_axis);
  vec3 across = from_foot - height * funnel_axis;
  float far = length(across);
  if (height < 1e-3 * funnel_radius_mm && far < 0.999 * funnel_radius_mm) return -funnel_axis;
  return normalize(across / max(far, 1e-6) - funnel_widening * funnel_axis);
}
