// The lens in patient space: a unit body, turned and stretched. Distances along rays stay what they are.
#define real float
#include LENS_BODY

uniform vec3 lens_centre_mm;
uniform mat3 body_from_patient;  // linear part: the body's own coordinates per mm
uniform float body_per_mm;       // the most that a length grows by it

// The ray's foot beside the lens' middle, in body coordinates, and how far along the ray it lies.
struct BodyRay {
  vec3 foot;
  vec3 direction;  // per mm
  float foot_mm;
};

BodyRay body_ray(vec3 origin_mm, vec3 direction) {
  vec3 to_origin = body_from_patient * (origin_mm - lens_centre_mm);
  vec3 along = body_from_patient * direction;
  float foot_mm = -dot(to_origin, along) / dot(along, along);
  return BodyRay(to_origin + foot_mm * along, along, foot_mm);
}

// Distances (entry, exit) in mm along the ray; exit <= entry: the ray misses the lens.
vec2 lens_interval(vec3 origin_mm, vec3 direction) {
  BodyRay ray = body_ray(origin_mm, direction);
  vec2 interval = unit_interval(ray.foot, ray.direction);
  return interval.y > interval.x ? ray.foot_mm + interval : vec2(0.0);
}

// Unit outward normal at a point of the lens' surface.
vec3 lens_normal(vec3 position_mm) {
  return normalize(unit_normal(body_from_patient * (position_mm - lens_centre_mm)) * body_from_patient);
}

// How far from the lens' middle a ray passes, in units of its size: 0 through the middle, 1 at the rim, beyond 1 past it;
// a lens behind the eye is passed far away.
float lens_offset(vec3 origin_mm, vec3 direction) {
  BodyRay ray = body_ray(origin_mm, direction);
  vec2 interval = unit_interval(ray.foot, ray.direction);
  if (interval.y <= interval.x || ray.foot_mm + interval.y <= 0.0) return 2.0;
  return unit_offset(ray.foot, ray.direction);
}

// How much deeper the lens' surface may lie `reach_mm` beside the ray, which crosses the lens in `lens_mm`.
float lens_rim_mm(vec3 origin_mm, vec3 direction, vec2 lens_mm, float reach_mm) {
  BodyRay ray = body_ray(origin_mm, direction);
  return unit_rim(ray.foot, ray.direction, lens_mm - ray.foot_mm, reach_mm * body_per_mm);
}
