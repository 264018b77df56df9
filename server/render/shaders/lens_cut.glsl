// How the cutaway divides a ray: outside of the lens only the context exists, inside only the focus.

#include "view.glsl"

uniform bool flat_caps;   // material cut by the lens shows a face of the lens; else the gradient's normal
uniform bool open_caps;   // material cut by the lens shows nothing: its surface must be entered
uniform float rim_mm;     // how far beyond the lens focus is looked for that the lens has cut off, at the least
uniform float pixel_size; // perspective: mm a pixel per mm of distance, orthographic: mm a pixel

// Values of LENS_MODE, which is defined for each program: a test of a uniform would run both sides in software.
#define LENS_NONE 0
#define LENS_CUTAWAY 1
#define LENS_MAGIC 2

// A ray's way through the volume, and the lens' interval within it; where the ray meets no lens, both of its ends are the
// volume's end. Up to the funnel's end there is no context.
struct Course {
  vec2 volume_mm;
  vec2 lens_mm;
  float funnel_end_mm;
};

// Parts of a course in the ray's order.
const int BEFORE_LENS = 0;
const int IN_LENS = 1;
const int BEHIND_LENS = 2;

struct Stretch {
  int branch;
  vec2 band;  // see band_of
  float begin_mm;
  float end_mm;      // not behind begin_mm: the ray has no such part
  bool starts_open;  // the material at the begin does not count; its surface must be entered first
};

// An eye inside of the volume sees no cut where it stands.
Stretch stretch_of(Course course, int part) {
  Stretch stretch;
  stretch.branch = part == IN_LENS ? FOCUS : CONTEXT;
  stretch.band = band_of(stretch.branch);
  stretch.begin_mm = part == BEFORE_LENS ? course.volume_mm.x : part == IN_LENS ? course.lens_mm.x : course.lens_mm.y;
#if LENS_MODE == LENS_CUTAWAY
  if (part != IN_LENS) stretch.begin_mm = max(stretch.begin_mm, course.funnel_end_mm);
#endif
  stretch.end_mm = part == BEFORE_LENS ? course.lens_mm.x : part == IN_LENS ? course.lens_mm.y : course.volume_mm.y;
  stretch.starts_open = stretch.begin_mm > course.volume_mm.x ? open_caps : course.volume_mm.x == 0.0;
  return stretch;
}

// What the funnel opens to view above the lens' middle is skin as ever, unless it is cut.
bool is_behind_lens(Course course, float distance_mm) {
  bool is_funnels_cut = course.funnel_end_mm > course.volume_mm.x && distance_mm <= course.funnel_end_mm;
  return (course.lens_mm.y > course.lens_mm.x && distance_mm >= course.lens_mm.y) || is_funnels_cut;
}

bool is_empty(Stretch stretch) { return stretch.end_mm <= stretch.begin_mm; }

Course outside_lens(vec2 volume_mm) { return Course(volume_mm, volume_mm.yy, 0.0); }
Course inside_lens(vec2 volume_mm) { return Course(volume_mm, volume_mm, 0.0); }

Course course_of(Ray ray, vec2 volume_mm) {
#if LENS_MODE == LENS_CUTAWAY
  vec2 lens_mm = lens_interval(ray.origin_mm, ray.direction);
  vec2 within = vec2(max(lens_mm.x, volume_mm.x), min(lens_mm.y, volume_mm.y));
  float clear_mm = funnel_exit_mm(ray.origin_mm, ray.direction);
  // No more than a ball's half lies within the funnel: whatever reaches out of it, rays come to the lens without context.
  if (funnel_radius_mm > 0.0 && within.y > within.x) clear_mm = max(clear_mm, within.x);
  if (within.y <= within.x) within = volume_mm.yy;
  return Course(volume_mm, within, clear_mm);
#else
  return outside_lens(volume_mm);
#endif
}

// The face of the volume's box through which the ray came in: tissue that the box cuts gets a flat face.
vec3 box_face(Ray ray, float distance_mm) {
  vec3 position = position_along(ray, distance_mm);
  vec3 to_face = min(abs(position - first_centre()), abs(last_centre() - position)) / all_rays.voxel_size;
  vec3 face = vec3(lessThanEqual(to_face, min(to_face.yzx, to_face.zxy)));
  return normalize(all_rays.axes * (face * -sign(ray.volume_per_mm)));
}

// The face that the lens cuts into material at a distance along the ray, seen from the viewer's side.
vec3 lens_face(Ray ray, float distance_mm, bool is_funnel) {
  if (!flat_caps) return vec3(0.0);
  vec3 position_mm = ray.origin_mm + distance_mm * ray.direction;
  vec3 normal = is_funnel ? funnel_normal(position_mm) : lens_normal(position_mm);
  return faceforward(normal, ray.direction, normal);
}

// Normal of the cut where a stretch starts in material; zero: the gradient's.
vec3 face_at_begin(Ray ray, Course course, float begin_mm) {
#if LENS_MODE == LENS_CUTAWAY
  if (begin_mm > course.volume_mm.x) return lens_face(ray, begin_mm, begin_mm == course.funnel_end_mm);
#endif
  return box_face(ray, begin_mm);
}

// How much deeper the lens' surface lies two pixels away, at the most: towards its rim that grows without bound. A surface
// that runs out of the lens between two pixels goes on within this length of the lens' end.
float rim_depth_mm(Ray ray, Course course) {
  float reach_mm = 2.0 * pixel_size * (is_perspective ? course.lens_mm.y : 1.0);
  return rim_mm + reach_mm + lens_rim_mm(ray.origin_mm, ray.direction, course.lens_mm, reach_mm);
}

// Whether a ray that has met no focus inside of the lens would do so just outside. Then the lens has cut the focus off
// there, and its end is no outline of the anatomy.
bool is_cut_off(Ray ray, Course course, bool is_asked) {
  const int SAMPLES = 8;
  vec2 band = band_of(FOCUS);
  float depth_mm = rim_depth_mm(ray, course);
  float step_outside_mm = depth_mm / float(SAMPLES);
  BrickRay bricks = brick_ray(ray);
  bool may_be = may_be_near(FOCUS, bricks, course.lens_mm.x, depth_mm) ||
                may_be_near(FOCUS, bricks, course.lens_mm.y, depth_mm);
  bool found = false;
  for (int i = 1; i <= SAMPLES && is_asked && may_be && !found; ++i) {
    float behind_mm = course.lens_mm.y + float(i) * step_outside_mm;
    float before_mm = course.lens_mm.x - float(i) * step_outside_mm;
    found = (behind_mm < course.volume_mm.y && band_side(band, value_along(ray, behind_mm)) == IN_BAND) ||
            (before_mm > course.volume_mm.x && band_side(band, value_along(ray, before_mm)) == IN_BAND);
  }
  return found;
}

// Why a ray that meets no focus does not: see branches.glsl.
float focus_reason(Ray ray, Course course, bool reaches_lens, bool meets_context) {
  bool crosses_lens = reaches_lens && course.lens_mm.y > course.lens_mm.x;
  bool cut_off = is_cut_off(ray, course, crosses_lens);
  if (crosses_lens) return cut_off ? REASON_OTHER_BRANCH : REASON_LEFT_LENS;
  return meets_context ? REASON_OTHER_BRANCH : REASON_LEFT_VOLUME;
}

// Whether the Magic Lens covers the ray: it is a mask on the picture, however deep the sphere lies.
bool is_under_lens(Ray ray) {
  vec2 lens_mm = lens_interval(ray.origin_mm, ray.direction);
  return lens_mm.y > max(lens_mm.x, 0.0);
}
