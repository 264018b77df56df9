// The context where the lens has cut it open, or where it is seen through the lens: the cavity's wall. Its tone parts the
// focus from the skin; without one the hole does not read as a hole.

const int TISSUES = 65;

uniform bool section;             // cut faces in the colours of tissue
uniform vec3 tissue[TISSUES];     // by value, evenly
uniform vec2 tissue_range;        // stored units
uniform float wall_strength;
uniform vec3 wall_colour;
uniform float wall_deepening;     // per lens radius
uniform float wall_edge_mm;
uniform vec3 wall_edge_colour;
uniform vec2 context_limits;      // stored units
uniform vec3 wall_centre_mm;      // of the lens
uniform float wall_radius_mm;

// Beneath a surface that is not cut, so far down that it is not the air's share in its voxels that colours it.
const float UNDER_SKIN_MM = 2.0;

vec3 tissue_at(vec3 position) {
  float share = clamp((stored_value(position) - tissue_range.x) / (tissue_range.y - tissue_range.x), 0.0, 1.0);
  float at = share * float(TISSUES - 1);
  int below = min(int(at), TISSUES - 2);
  return mix(tissue[below], tissue[below + 1], at - float(below));
}

// Share of the directions along the cut in which the material ends within the edge's width.
float edge_at(vec3 position, vec3 normal) {
  vec3 aside = normalize(abs(normal.x) < 0.7 ? cross(normal, vec3(1.0, 0.0, 0.0)) : cross(normal, vec3(0.0, 1.0, 0.0)));
  vec3 across = cross(normal, aside);
  float ends = 0.0;
  for (int i = 0; i < (wall_edge_mm > 0.0 ? 12 : 0); ++i) {
    float angle = 0.5235988 * float(i);
    vec3 off_mm = wall_edge_mm * (cos(angle) * aside + sin(angle) * across);
    float value = stored_value(position + patient_to_volume * off_mm);
    ends += value < context_limits.x || value > context_limits.y ? 1.0 : 0.0;
  }
  return clamp(ends / 3.0, 0.0, 1.0);
}

// `shaded`: as the rest of the context is.
vec3 wall_of(vec3 shaded, vec4 surface, Ray ray) {
  vec3 normal = normal_of(surface);
  bool is_cut = is_cut_face(surface);
  bool is_wall = lies_behind_lens(surface);
  vec3 position = ray.origin + surface.w * ray.volume_per_mm;
  vec3 under = is_cut ? vec3(0.0) : patient_to_volume * (-UNDER_SKIN_MM * normal);
  vec3 colour = shaded;
  if (section && (is_cut || is_wall))
    colour = tissue_at(position + under) * (0.85 + 0.15 * dot(normal, light_direction));
  if (!is_wall) return colour;
  colour = mix(colour, wall_colour, wall_strength);
  if (is_cut) colour = mix(colour, wall_edge_colour, edge_at(position, normal));
  float depth_mm = dot(ray.origin_mm + surface.w * ray.direction - wall_centre_mm, normalize(view_forward));
  return colour * exp(-wall_deepening * max(depth_mm, 0.0) / wall_radius_mm);
}
