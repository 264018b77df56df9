// Skipping bricks in which a branch's surface cannot be. A brick's distance D (in bricks, Chebyshev) to the nearest one
// that reaches the iso-value lets a sample skip to the exit of the cube of 2D-1 bricks around it.
// Source: Deakin and Knackstedt, "Accelerated Volume Rendering with Chebyshev Distance Maps", SIGGRAPH Asia 2019.

uniform usampler3D distance_maps;     // a component for each branch
uniform float brick_size;             // cells
uniform ivec3 size_bricks;
uniform bool skip_empty_space;

int brick_distance(int branch, ivec3 brick) {
  uvec2 distances = texelFetch(distance_maps, brick, 0).rg;
  return int(branch == FOCUS ? distances.y : distances.x);
}

// Distance along the ray (mm) up to which nothing can be hit, from the sample at `index`; 0 where it must be looked at.
float empty_until_mm(int branch, vec3 index, Ray ray) {
  ivec3 brick = clamp(ivec3(floor(index / brick_size)), ivec3(0), size_bricks - 1);
  int reach = brick_distance(branch, brick);
  if (reach == 0) return 0.0;
  vec3 low = vec3(brick - (reach - 1)) * brick_size;
  vec3 high = vec3(brick + reach) * brick_size;
  vec3 exits = (mix(low, high, greaterThan(ray.index_per_mm, vec3(0.0))) - ray.origin_index) / ray.index_per_mm;
  return min(min(exits.x, exits.y), exits.z);
}
