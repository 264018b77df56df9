// Finding where a value first enters a branch's band within a stretch of the ray.

uniform vec2 lower_limits;   // of the bands, stored units, by branch
uniform vec2 upper_limits;   // without an upper end: larger than any value
uniform bool has_upper_limit[2];
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

// Where a value lies: below the band, in it, above it.
const int BELOW = -1;
const int IN_BAND = 0;
const int ABOVE = 1;

int band_side(int branch, float value) {
  return value <= lower_limits[branch] ? BELOW : value >= upper_limits[branch] ? ABOVE : IN_BAND;
}

float value_along(Ray ray, float distance_mm) {
  return stored_value(ray.origin_index + distance_mm * ray.index_per_mm);
}

// The crossing of a limit within [near, far] by a value that has left `side` at far: regula falsi in the Illinois variant,
// which halves the weight of an end that stays, so that both ends close in.
float refine(Ray ray, int branch, int side, float near_mm, float far_mm) {
  float limit = side == BELOW ? lower_limits[branch] : upper_limits[branch];
  float near_gap = abs(value_along(ray, near_mm) - limit);
  float far_gap = abs(value_along(ray, far_mm) - limit);
  int kept = 0;  // 1: the near end stayed the last time, -1: the far end
  for (int i = 0; i < refinement_steps; ++i) {
    float guess_mm = mix(near_mm, far_mm, near_gap / max(near_gap + far_gap, 1e-12));
    float value = value_along(ray, guess_mm);
    float gap = abs(value - limit);
    if (side == BELOW ? value > limit : value < limit) {
      far_mm = guess_mm;
      far_gap = gap;
      near_gap *= kept == 1 ? 0.5 : 1.0;
      kept = 1;
    } else {
      near_mm = guess_mm;
      near_gap = gap;
      far_gap *= kept == -1 ? 0.5 : 1.0;
      kept = -1;
    }
  }
  return mix(near_mm, far_mm, near_gap / max(near_gap + far_gap, 1e-12));
}

// Number of the first sample of the lattice behind a distance.
int sample_after(Stretch stretch, float distance_mm) {
  return int(floor((distance_mm - stretch.lattice_mm) / step_mm)) + 1;
}

// Distance of the first hit in mm, or NO_HIT. A hit at exactly `begin_mm` is a cap: the stretch starts in material. A band
// that is jumped over between two samples is hit at the limit that was crossed first.
float search_surface(Ray ray, Stretch stretch) {
  int side = band_side(stretch.branch, value_along(ray, stretch.begin_mm));
  if (side == IN_BAND && !stretch.starts_open) return stretch.begin_mm;
  int sample_number = sample_after(stretch, stretch.begin_mm);
  float before_mm = stretch.begin_mm;
  while (before_mm < stretch.end_mm) {
    float at_mm = min(stretch.lattice_mm + float(sample_number) * step_mm, stretch.end_mm);
    vec3 index = ray.origin_index + at_mm * ray.index_per_mm;
    float empty_mm = skip_empty_space ? empty_until_mm(stretch.branch, index, ray) : 0.0;
    bool is_empty = empty_mm > 0.0;
    // An empty brick lies on one side of the band; without an upper end that can only be below.
    int side_here = is_empty && !has_upper_limit[stretch.branch] ? BELOW : band_side(stretch.branch, stored_value(index));
    if (side_here != side && side != IN_BAND) return refine(ray, stretch.branch, side, before_mm, at_mm);
    side = side_here;
    sample_number = is_empty ? max(sample_number + 1, sample_after(stretch, empty_mm)) : sample_number + 1;
    // After a skip this is the last sample that is still known to lie on the same side.
    before_mm = min(stretch.lattice_mm + float(sample_number - 1) * step_mm, stretch.end_mm);
  }
  return NO_HIT;
}
