// Finding where a value first rises to a branch's iso-value within a stretch of the ray.

uniform vec2 iso_values;      // stored units, by branch
uniform float step_mm;
uniform int refinement_steps;

const float NO_HIT = -1.0;

struct Stretch {
  int branch;
  float begin_mm;
  float end_mm;
  float lattice_mm;   // where the ray's samples are counted from: all stretches of a ray share one lattice
  bool starts_open;   // the material at the begin does not count; its surface must be entered first
};

float value_along(Ray ray, float distance_mm) {
  return stored_value(ray.origin_index + distance_mm * ray.index_per_mm);
}

// The crossing within [low, high], where the value is below the iso-value at low and not below it at high: one
// secant step for the usual nearly linear ramp, then bisection with the bracket kept.
float refine(Ray ray, float iso_value, float low_mm, float high_mm) {
  float low_value = value_along(ray, low_mm);
  float high_value = value_along(ray, high_mm);
  float guess_mm = mix(low_mm, high_mm, clamp((iso_value - low_value) / max(high_value - low_value, 1e-12), 0.0, 1.0));
  for (int i = 0; i < refinement_steps; ++i) {
    bool reached = value_along(ray, guess_mm) >= iso_value;
    low_mm = reached ? low_mm : guess_mm;
    high_mm = reached ? guess_mm : high_mm;
    guess_mm = 0.5 * (low_mm + high_mm);
  }
  return guess_mm;
}

// Distance of the first hit in mm, or NO_HIT. A hit at exactly `begin_mm` is a cap: the stretch starts in material.
float search_surface(Ray ray, Stretch stretch) {
  float iso_value = iso_values[stretch.branch];
  bool inside = value_along(ray, stretch.begin_mm) >= iso_value;
  if (inside && !stretch.starts_open) return stretch.begin_mm;
  int sample_number = int(floor((stretch.begin_mm - stretch.lattice_mm) / step_mm)) + 1;
  float before_mm = stretch.begin_mm;
  while (before_mm < stretch.end_mm) {
    float at_mm = min(stretch.lattice_mm + float(sample_number) * step_mm, stretch.end_mm);
    vec3 index = ray.origin_index + at_mm * ray.index_per_mm;
    float empty_mm = skip_empty_space ? empty_until_mm(stretch.branch, index, ray) : 0.0;
    if (empty_mm > 0.0) {
      inside = false;
      sample_number = max(sample_number + 1, int(floor((empty_mm - stretch.lattice_mm) / step_mm)) + 1);
    } else {
      bool reached = stored_value(index) >= iso_value;
      if (reached && !inside) return refine(ray, iso_value, before_mm, at_mm);
      inside = reached;
      ++sample_number;
    }
    // After a skip this is the last point of the lattice that is still known to be empty.
    before_mm = min(stretch.lattice_mm + float(sample_number - 1) * step_mm, stretch.end_mm);
  }
  return NO_HIT;
}
