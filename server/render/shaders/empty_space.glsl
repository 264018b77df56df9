// Skipping bricks in which a branch's surface cannot be. A brick's distance D (in bricks, Chebyshev) to the nearest one
// that reaches the iso-value lets a sample skip to the exit of the cube of 2D-1 bricks around it.
// Source: Deakin and Knackstedt, "Accelerated Volume Rendering with Chebyshev Distance Maps", SIGGRAPH Asia 2019.

uniform usampler3D distance_maps;  // a component for each branch
uniform bool skip_empty_space;

// A ray among the bricks. What it needs again and again is worked out once: divisions are dear in software.
struct BrickRay {
  vec3 origin;    // bricks
  vec3 per_mm;    // bricks
  vec3 mm_per;    // of a brick
  vec3 way;       // 1 where the ray goes up, else -1
  vec3 far_side;  // of a brick: 0 where the ray goes up, else 1
};

BrickRay brick_ray(Ray ray) {
  vec3 per_mm = ray.volume_per_mm * all_rays.bricks_per_volume;
  vec3 origin = ray.origin * all_rays.bricks_per_volume - all_rays.first_centre_bricks;
  vec3 way = sign(per_mm);
  return BrickRay(origin, per_mm, 1.0 / per_mm, way, 0.5 - 0.5 * way);
}

float bricks_to_surface(int branch, vec3 brick) {
  uvec2 distances = textureLod(distance_maps, (brick + 0.5) * all_rays.brick_in_map, 0.0).rg;
  return float(branch == FOCUS ? distances.y : distances.x);
}

// Whether a branch's surface may be within a length of the ray's point.
bool may_be_near(int branch, BrickRay ray, float at_mm, float length_mm) {
  if (!skip_empty_space) return true;
  float clear_bricks = bricks_to_surface(branch, floor(ray.origin + at_mm * ray.per_mm)) - 1.0;
  return clear_bricks * all_rays.brick_mm < length_mm;
}

// Distance along the ray (mm) up to which nothing can be hit from `at_mm` on; not beyond it where the sample there must be
// looked at.
float empty_until_mm(int branch, BrickRay ray, float at_mm) {
  vec3 brick = floor(ray.origin + at_mm * ray.per_mm);
  vec3 exits = (brick + ray.far_side + bricks_to_surface(branch, brick) * ray.way - ray.origin) * ray.mm_per;
  return min(min(exits.x, exits.y), exits.z);
}
