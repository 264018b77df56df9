// unit_offset and unit_rim of a body that is known by its interval and its gauge alone.

// A gauge is convex along a line: thirds close in on its least value.
real unit_offset(vec3 origin, vec3 direction) {
  const int STEPS = 40;
  vec2 within = unit_interval(origin, direction);
  for (int i = 0; i < STEPS; ++i) {
    real third = (within.y - within.x) / 3.0;
    real before = unit_gauge(origin + (within.x + third) * direction);
    real behind = unit_gauge(origin + (within.y - third) * direction);
    if (before < behind) within.y -= third;
    else within.x += third;
  }
  return unit_gauge(origin + 0.5 * (within.x + within.y) * direction);
}

real unit_rim(vec3 origin, vec3 direction, vec2 interval, real reach) {
  vec3 inward = max(0.0, 1.0 - reach / max(length(origin), UNIT_PARALLEL)) * origin;
  vec2 there = unit_interval(inward, direction);
  return max(max(there.y - interval.y, interval.x - there.x), 0.0);
}
