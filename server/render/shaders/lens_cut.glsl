// How the cutaway divides a ray: outside of the lens only the context exists, inside only the focus.

uniform int lens_mode;
uniform bool flat_caps;   // material cut by the lens shows a face of the lens; else the gradient's normal
uniform bool open_caps;   // material cut by the lens shows nothing: its surface must be entered
uniform float rim_mm;     // how far behind the lens focus is looked for that the lens has cut off

const int LENS_NONE = 0;
const int LENS_CUTAWAY = 1;
const int LENS_MAGIC = 2;

// A stretch with the normal of the cut where it starts in material; zero: the gradient's.
struct Part {
  Stretch stretch;
  vec3 face;
};

// The face of the volume's box through which the ray came in: tissue that the box cuts gets a flat face.
vec3 box_face(Ray ray, float distance_mm) {
  vec3 index = ray.origin_index + distance_mm * ray.index_per_mm;
  vec3 to_face = min(abs(index), abs(last_index() - index));
  vec3 face = vec3(lessThanEqual(to_face, min(to_face.yzx, to_face.zxy)));
  return normalize(volume_direction * (face * -sign(ray.index_per_mm)));
}

// The face that the lens cuts into material at a distance along the ray, seen from the viewer's side.
vec3 lens_face(Ray ray, float distance_mm) {
  if (!flat_caps) return vec3(0.0);
  vec3 normal = lens_normal(ray.origin_mm + distance_mm * ray.direction);
  return faceforward(normal, ray.direction, normal);
}

// The ray's whole way through the volume. An eye inside of the volume sees no cut where it stands.
Part whole_ray(int branch, Ray ray, vec2 volume_mm) {
  bool starts_in_volume = volume_mm.x == 0.0;
  return Part(Stretch(branch, volume_mm.x, volume_mm.y, volume_mm.x, starts_in_volume), box_face(ray, volume_mm.x));
}

// The lens' interval within the volume's; where it is missed, both ends are the volume's end.
vec2 lens_within(Ray ray, vec2 volume_mm) {
  vec2 missed = volume_mm.yy;
  if (lens_mode != LENS_CUTAWAY) return missed;
  vec2 lens_mm = lens_interval(ray.origin_mm, ray.direction);
  vec2 within = vec2(max(lens_mm.x, volume_mm.x), min(lens_mm.y, volume_mm.y));
  return within.y > within.x ? within : missed;
}

const int CUTAWAY_PARTS = 3;

// In the ray's order: in front of the lens, inside it, behind it; empty where the ray has no such part.
Part cutaway_part(int number, Ray ray, vec2 volume_mm, vec2 lens_mm) {
  Part part = whole_ray(number == 1 ? FOCUS : CONTEXT, ray, volume_mm);
  part.stretch.begin_mm = number == 0 ? volume_mm.x : number == 1 ? lens_mm.x : lens_mm.y;
  part.stretch.end_mm = number == 0 ? lens_mm.x : number == 1 ? lens_mm.y : volume_mm.y;
  if (part.stretch.begin_mm > volume_mm.x) {
    part.stretch.starts_open = open_caps;
    part.face = lens_face(ray, part.stretch.begin_mm);
  }
  return part;
}

bool is_empty(Part part) { return part.stretch.end_mm <= part.stretch.begin_mm; }

// Whether a ray that has met no focus inside of the lens would do so just behind it. Then the lens has cut the focus off
// there, and its end is no outline of the anatomy.
bool is_cut_off(Ray ray, float lens_end_mm, float volume_end_mm) {
  const int SAMPLES = 3;
  for (int i = 1; i <= SAMPLES; ++i) {
    float at_mm = lens_end_mm + rim_mm * float(i) / float(SAMPLES);
    if (at_mm < volume_end_mm && band_side(FOCUS, value_along(ray, at_mm)) == IN_BAND) return true;
  }
  return false;
}

// Why a ray that meets no focus does not: see branches.glsl.
float focus_reason(Ray ray, vec2 volume_mm, vec2 lens_mm, bool reaches_lens, bool meets_context) {
  bool crosses_lens = reaches_lens && lens_mm.y > lens_mm.x;
  if (crosses_lens) return is_cut_off(ray, lens_mm.y, volume_mm.y) ? REASON_OTHER_BRANCH : REASON_LEFT_LENS;
  return meets_context ? REASON_OTHER_BRANCH : REASON_LEFT_VOLUME;
}

// Whether the Magic Lens covers the ray: it is a mask on the picture, however deep the sphere lies.
bool is_under_lens(Ray ray) {
  vec2 lens_mm = lens_interval(ray.origin_mm, ray.direction);
  return lens_mm.y > max(lens_mm.x, 0.0);
}
