// Finding where a ray first meets a branch's band.
//
// A software rasteriser runs both sides of every branch, for eight rays at a time, and leaves a loop once all eight are
// through: so one loop, with one sample of the volume in it, goes through all parts of the ray, and what a ray that meets
// nothing does not need stands in loops too.

uniform sampler2D entry_texture;  // mm along the ray before which there is nothing of either branch
uniform float step_mm;
uniform int refinement_steps;

const float NO_HIT = -1.0;

struct Hit {
  int branch;
  float distance_mm;  // NO_HIT where there is no surface
  vec3 normal;
};

// Two neighbouring samples; the surface is between them. Without a surface `far_mm` is NO_HIT.
struct Bracket {
  int branch;
  int side;  // of the band, at near_mm
  float near_mm;
  float far_mm;
  bool is_cut;  // the part starts in material, at far_mm
};

// All samples of a ray lie on one lattice, whatever is skipped: this is the number of the first one behind a distance.
int sample_after(Course course, float distance_mm) {
  return int(floor((distance_mm - course.volume_mm.x) / step_mm)) + 1;
}

float sample_mm(Course course, int number) { return course.volume_mm.x + float(number) * step_mm; }

// Number of the last sample before the ray comes to anything.
int sample_before_entry(Course course) {
  float entry_mm = texelFetch(entry_texture, ivec2(gl_FragCoord.xy), 0).r;
  return sample_after(course, entry_mm) - 2;  // one to spare for rounding
}

// Number of the next sample that must be looked at after the one at `at_mm`; `number` is the last one up to there.
int next_sample(Ray ray, Course course, Stretch stretch, float at_mm, int number) {
  int reached = number;
  bool leaps = skip_empty_space;
  while (leaps) {
    float empty_mm = empty_until_mm(stretch.branch, index_along(ray, at_mm), ray);
    if (empty_mm > 0.0) reached = max(reached + 1, sample_after(course, empty_mm));
    at_mm = sample_mm(course, reached);
    leaps = empty_mm > 0.0 && at_mm < stretch.end_mm;
  }
  return max(number + 1, reached);
}

// The search's state: where it looks next, and what it knows of the sample before.
struct Search {
  Stretch stretch;
  float at_mm;
  int number;   // the last sample up to at_mm
  bool begins;  // at the begin of the stretch, of whose sides nothing is known
};

// Where the begin lies before anything that the ray comes to, it is below a band without an upper end.
Search search_of(Course course, int part, int before_entry) {
  Stretch stretch = stretch_of(course, part);
  int number = sample_after(course, stretch.begin_mm) - 1;
  if (before_entry <= number || upper_limits[stretch.branch] < NO_UPPER_LIMIT)
    return Search(stretch, stretch.begin_mm, number, true);
  return Search(stretch, min(sample_mm(course, before_entry), stretch.end_mm), before_entry, false);
}

// The first surface in the parts from `part` to `last` of a course.
Bracket bracket_surface(Ray ray, Course course, int part, int last) {
  int before_entry = skip_empty_space ? sample_before_entry(course) : -1;
  if (part < last && is_empty(stretch_of(course, part))) ++part;
  Search search = search_of(course, part, before_entry);
  Bracket bracket = Bracket(search.stretch.branch, BELOW, search.stretch.begin_mm, NO_HIT, false);
  bool searches = !is_empty(search.stretch);
  while (searches) {
    int side = band_side(search.stretch.branch, value_along(ray, search.at_mm));
    bool is_cut = search.begins && side == IN_BAND && !search.stretch.starts_open;
    bool enters = !search.begins && side != bracket.side && bracket.side != IN_BAND;
    if (is_cut || enters) {
      bracket.branch = search.stretch.branch;
      bracket.far_mm = search.at_mm;
      bracket.is_cut = is_cut;
      searches = false;
    } else if (search.at_mm < search.stretch.end_mm) {
      // What is leapt over lies on this side too: its last sample is as good as one that was looked at.
      search.number = next_sample(ray, course, search.stretch, search.at_mm, search.number);
      bracket.near_mm = max(search.at_mm, min(sample_mm(course, search.number - 1), search.stretch.end_mm));
      bracket.side = side;
      search.at_mm = min(sample_mm(course, search.number), search.stretch.end_mm);
      search.begins = false;
    } else {
      search = search_of(course, ++part, before_entry);
      bracket.side = BELOW;
      searches = part <= last && !is_empty(search.stretch);
    }
  }
  return bracket;
}

// Whether the context is met only where the lens has taken it away: no outline of the anatomy either.
bool is_context_in_lens(Ray ray, Course course, bool is_asked) {
  Course lens = outside_lens(is_asked ? course.lens_mm : vec2(0.0));
  return bracket_surface(ray, lens, BEFORE_LENS, BEFORE_LENS).far_mm != NO_HIT;
}

// The crossing of a limit in the bracket: regula falsi in the Illinois variant, which halves the weight of an end that
// stays, so that both ends close in.
float refine(Ray ray, Bracket bracket) {
  float limit = bracket.side == BELOW ? lower_limits[bracket.branch] : upper_limits[bracket.branch];
  float near_gap = abs(value_along(ray, bracket.near_mm) - limit);
  float far_gap = abs(value_along(ray, bracket.far_mm) - limit);
  int kept = 0;  // 1: the near end stayed the last time, -1: the far end
  int steps = bracket.far_mm == NO_HIT || bracket.is_cut ? 0 : refinement_steps;
  for (int i = 0; i < steps; ++i) {
    float guess_mm = mix(bracket.near_mm, bracket.far_mm, near_gap / max(near_gap + far_gap, 1e-12));
    float value = value_along(ray, guess_mm);
    float gap = abs(value - limit);
    if (bracket.side == BELOW ? value > limit : value < limit) {
      bracket.far_mm = guess_mm;
      far_gap = gap;
      near_gap *= kept == 1 ? 0.5 : 1.0;
      kept = 1;
    } else {
      bracket.near_mm = guess_mm;
      near_gap = gap;
      far_gap *= kept == -1 ? 0.5 : 1.0;
      kept = -1;
    }
  }
  if (steps == 0) return bracket.far_mm;
  return mix(bracket.near_mm, bracket.far_mm, near_gap / max(near_gap + far_gap, 1e-12));
}

// The first surface in the parts from `first` to `last` of a course; where there is none, of any branch.
Hit search_surface(Ray ray, Course course, int first, int last) {
  Bracket bracket = bracket_surface(ray, course, first, last);
  float distance_mm = refine(ray, bracket);
  bool is_hit = distance_mm != NO_HIT;
  vec3 face = bracket.is_cut ? face_at_begin(ray, course, distance_mm) : vec3(0.0);
  vec3 normal = normal_towards_viewer(index_along(ray, distance_mm), ray.direction, is_hit && face == vec3(0.0));
  return Hit(bracket.branch, distance_mm, face == vec3(0.0) ? normal : face);
}
