// Finding where a ray first meets a branch's band.
//
// A software rasteriser runs both sides of every branch, for eight rays at a time, and leaves a loop once all eight are
// through: so one loop, with a few samples of the volume in it, goes through all parts of the ray, and what a ray that
// meets nothing does not need stands in loops too.

uniform sampler2D entry_texture;  // mm along the ray before which there is nothing of either branch

const float NO_HIT = -1.0;

// Of the surface's position between two samples, at the most; the usual, nearly linear ramp needs two.
const int REFINEMENT_STEPS = 5;

// After a leap. Looking at a sample needlessly costs less than asking each time whether it must be looked at.
const int SAMPLES_A_LOOK = 4;

struct Hit {
  int branch;
  float distance_mm;  // NO_HIT where there is no surface
  vec3 normal;
  bool is_cut;  // a face of the lens or of the volume's box
};

// Two neighbouring samples; the surface is between them. Without a surface `far_mm` is NO_HIT.
struct Bracket {
  int branch;
  int side;  // of the band, at near_mm
  float near_mm;
  float far_mm;
  float far_value;
  bool is_cut;  // the part starts in material, at far_mm
};

// All samples of a ray lie on one lattice, whatever is skipped: this is the number of the first one behind a distance.
// A whole number, exact in a float.
float sample_after(Course course, float distance_mm) {
  return floor((distance_mm - course.volume_mm.x) * all_rays.samples_per_mm) + 1.0;
}

float sample_mm(Course course, float number) { return course.volume_mm.x + number * all_rays.step_mm; }

// Number of the last sample before the ray comes to anything.
float sample_before_entry(Course course) {
  float entry_mm = texelFetch(entry_texture, ivec2(gl_FragCoord.xy), 0).r;
  return sample_after(course, entry_mm) - 2.0;  // one to spare for rounding
}

// Number of the next sample that must be looked at after the one at `at_mm`; `number` is the last one up to there.
float next_sample(BrickRay bricks, Course course, Stretch stretch, float at_mm, float number) {
  float reached = number;
  bool leaps = skip_empty_space;
  while (leaps) {
    float empty_mm = empty_until_mm(stretch.branch, bricks, at_mm);
    leaps = empty_mm > at_mm;
    if (leaps) reached = max(reached + 1.0, sample_after(course, empty_mm));
    at_mm = sample_mm(course, reached);
    leaps = leaps && at_mm < stretch.end_mm;
  }
  return max(number + 1.0, reached);
}

// The search's state.
struct Search {
  Stretch stretch;
  float at_mm;      // where it looks, or has looked
  float number;     // the last sample up to there
  float looked_mm;  // the sample before
  int side;         // of the band, at the last one looked at
  bool begins;      // at the begin of the stretch, which has not been looked at
};

// Where the begin lies before anything that the ray comes to, it is below a band without an upper end.
Search search_of(Course course, int part, float before_entry) {
  Stretch stretch = stretch_of(course, part);
  float number = sample_after(course, stretch.begin_mm) - 1.0;
  if (before_entry <= number || stretch.band.y < NO_UPPER_LIMIT)
    return Search(stretch, stretch.begin_mm, number, stretch.begin_mm, BELOW, true);
  float at_mm = min(sample_mm(course, before_entry), stretch.end_mm);
  return Search(stretch, at_mm, before_entry, at_mm, BELOW, false);
}

// Moves on to the next sample that must be looked at. What is leapt over lies on the side of the sample before: its last
// sample is as good as one that was looked at.
void advance(BrickRay bricks, Course course, inout Search search) {
  float looked_mm = search.at_mm;
  search.number = next_sample(bricks, course, search.stretch, looked_mm, search.number);
  search.looked_mm = max(looked_mm, min(sample_mm(course, search.number - 1.0), search.stretch.end_mm));
  search.at_mm = min(sample_mm(course, search.number), search.stretch.end_mm);
}

// Looks at a few samples in a row. Returns whether there is a surface among them.
bool look(Ray ray, Course course, inout Search search, inout Bracket bracket) {
  bool found = false;
  for (int i = 0; i < SAMPLES_A_LOOK; ++i) {
    if (i > 0) search.at_mm = min(sample_mm(course, search.number + float(i)), search.stretch.end_mm);
    float value = value_along(ray, search.at_mm);
    int side = band_side(search.stretch.band, value);
    bool is_cut = search.begins && side == IN_BAND && !search.stretch.starts_open;
    bool enters = !search.begins && side != search.side && search.side != IN_BAND;
    if (!found && (is_cut || enters)) {
      bracket = Bracket(search.stretch.branch, search.side, search.looked_mm, search.at_mm, value, is_cut);
      found = true;
    }
    search.looked_mm = search.at_mm;
    search.side = side;
    search.begins = false;
  }
  search.number += float(SAMPLES_A_LOOK - 1);
  return found;
}

// The first surface in the parts from `part` to `last` of a course.
Bracket bracket_surface(Ray ray, Course course, int part, int last) {
  BrickRay bricks = brick_ray(ray);
  float before_entry = skip_empty_space ? sample_before_entry(course) : -1.0;
  if (part < last && is_empty(stretch_of(course, part))) ++part;
  Search search = search_of(course, part, before_entry);
  Bracket bracket = Bracket(search.stretch.branch, BELOW, search.stretch.begin_mm, NO_HIT, 0.0, false);
  bool searches = !is_empty(search.stretch);
  while (searches) {
    if (!search.begins) advance(bricks, course, search);
    bool found = look(ray, course, search, bracket);
    searches = !found;
    if (!found && search.at_mm >= search.stretch.end_mm) {
      ++part;
      search = search_of(course, part, before_entry);
      searches = part <= last && !is_empty(search.stretch);
    }
  }
  return bracket;
}

// Whether the context is met only where the lens has taken it away: no outline of the anatomy either.
bool is_context_in_lens(Ray ray, Course course, bool is_asked) {
  bool is_opened = course.funnel_end_mm > course.volume_mm.x;
  bool crosses_lens = course.lens_mm.y > course.lens_mm.x;
  vec2 removed_mm = is_opened ? vec2(course.volume_mm.x, max(crosses_lens ? course.lens_mm.y : 0.0, course.funnel_end_mm))
                              : course.lens_mm;
  Course lens = outside_lens(is_asked ? removed_mm : vec2(0.0));
  return bracket_surface(ray, lens, BEFORE_LENS, BEFORE_LENS).far_mm != NO_HIT;
}

// The crossing of a limit in the bracket: regula falsi in the Illinois variant, which halves the weight of an end that
// stays, so that both ends close in. It ends once a guess is right to a thousandth of a step.
float refine(Ray ray, Bracket bracket) {
  vec2 band = band_of(bracket.branch);
  float limit = bracket.side == BELOW ? band.x : band.y;
  float near_gap = abs(value_along(ray, bracket.near_mm) - limit);
  float far_gap = abs(bracket.far_value - limit);
  float enough = 1e-3 * (near_gap + far_gap);
  int kept = 0;  // 1: the near end stayed the last time, -1: the far end
  int steps = bracket.far_mm == NO_HIT || bracket.is_cut ? 0 : REFINEMENT_STEPS;
  int taken = 0;
  while (taken < steps) {
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
    taken = gap < enough ? steps : taken + 1;
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
  vec3 normal = normal_towards_viewer(position_along(ray, distance_mm), ray.direction, is_hit && face == vec3(0.0));
  return Hit(bracket.branch, distance_mm, face == vec3(0.0) ? normal : face, face != vec3(0.0));
}
