#version 450 core
// How much light comes to a branch's surface: of the ambient light from all around what nothing near keeps away, and of the
// light itself what nothing throws a shadow on. Rays are marched through a coarse copy of the volume from one hit a pixel;
// their directions are turned and their samples moved from pixel to pixel in a pattern of 4 x 4, which the next pass
// smooths away.
// Source: F. Hernell, P. Ljung, A. Ynnerman, "Local Ambient Occlusion in Direct Volume Rendering", IEEE TVCG 16(4), 2010.

#include "branches.glsl"
#include "light.glsl"
#include "pixel_ray.glsl"
#include "view.glsl"
#include "volume.glsl"
#include "coarse_volume.glsl"
#include "lens.glsl"
#include "funnel.glsl"

uniform sampler2D surface_texture;
uniform int supersampling;
uniform vec2 bands[2];        // of context and focus, stored units
uniform float start_mm;       // before which a surface would be in its own way
uniform float range_mm;       // of what keeps ambient light away
uniform float near_share;
uniform int directions;
uniform int samples;
uniform vec2 disc[MOST_DIRECTIONS];  // evenly over the unit disc
uniform int shadow_rays;
uniform int shadow_samples;
uniform float shadow_spread;  // tangent of half the angle under which the light is seen
uniform float shadow_range_mm;

layout(location = 0) out vec2 reach;  // ambient, direct: 1 is all of it

const float SPACING = 1.5;  // exponent of the samples' places: denser near the surface
const float NEAR = 0.25;    // of the range

// 0..15 in an order that has each 2 x 2 as spread out as may be, of a pixel of the whole picture.
float turn_of_pixel() {
  ivec2 at = ivec2(gl_FragCoord.xy + pixel_rays.place.xy) & 3;
  int number = ((at.x & 1) << 3) | (((at.x ^ at.y) & 1) << 2) | ((at.x & 2)) | (((at.x ^ at.y) & 2) >> 1);
  return float(number) / 16.0;
}

bool is_in_band(int branch, float value) { return value > bands[branch].x && value < bands[branch].y; }

// A ray through the volume, and through the lens' body.
struct LightRay {
  vec3 origin;
  vec3 per_mm;
  vec3 origin_mm;
  vec3 direction;
  vec3 body_origin;
  vec3 body_per_mm;
};

LightRay light_ray(vec3 position_mm, vec3 position, vec3 direction) {
  LightRay ray;
  ray.origin = position;
  ray.per_mm = patient_to_volume * direction;
#if CUTAWAY
  ray.origin_mm = position_mm;
  ray.direction = direction;
  ray.body_origin = body_from_patient * (position_mm - lens_centre_mm);
  ray.body_per_mm = body_from_patient * direction;
#endif
  return ray;
}

// Whether there is something at a distance along the ray: the cutaway's rule holds for light, too.
bool is_blocked(LightRay ray, float at_mm) {
  float value = coarse_value(ray.origin + at_mm * ray.per_mm);
#if CUTAWAY
  bool in_lens = unit_gauge(ray.body_origin + at_mm * ray.body_per_mm) < 1.0;
  bool is_open = !in_lens && is_in_funnel(ray.origin_mm + at_mm * ray.direction);
  return !is_open && is_in_band(in_lens ? FOCUS : CONTEXT, value);
#else
  return is_in_band(BRANCH, value);
#endif
}

float end_in_volume_mm(LightRay ray) {
  vec3 ends = (step(vec3(0.0), ray.per_mm) - ray.origin) / ray.per_mm;
  return max(min(min(ends.x, ends.y), ends.z), 0.0);
}

// Distance to the first thing in the way; beyond the range where there is none. The last sample lies at the range's end,
// whatever the turn: a wall that begins just before it counts, too.
float blocked_at_mm(LightRay ray, float length_mm, int count, float turn) {
  float end_mm = min(length_mm, end_in_volume_mm(ray));
  float per_sample = 1.0 / max(float(count) - 1.0 + turn, 1e-3);
  float at_mm = 0.0;
  bool blocked = false;
  for (int i = 0; i < count && !blocked && at_mm <= end_mm; ++i) {
    at_mm = min(start_mm + (length_mm - start_mm) * pow((float(i) + turn) * per_sample, SPACING), length_mm);
    blocked = at_mm <= end_mm && is_blocked(ray, at_mm);
  }
  return blocked ? at_mm : 2.0 * length_mm;
}

// A frame with its third axis along a direction. Source: T. Duff et al., "Building an Orthonormal Basis, Revisited",
// JCGT 6(1), 2017.
mat3 frame_along(vec3 axis) {
  float side = axis.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (side + axis.z);
  float b = axis.x * axis.y * a;
  return mat3(vec3(1.0 + side * axis.x * axis.x * a, side * b, -side * axis.x),
              vec3(b, side + axis.y * axis.y * a, -axis.y), axis);
}

vec2 turned(vec2 point, float turn) {
  float angle = 6.2831853 * turn;
  return mat2(cos(angle), sin(angle), -sin(angle), cos(angle)) * point;
}

float ambient_reach(vec3 position_mm, vec3 position, vec3 normal, float turn) {
  mat3 frame = frame_along(normal);
  float open = 0.0;
  for (int k = 0; k < directions; ++k) {
    vec2 point = turned(disc[k], turn);
    vec3 direction = frame * vec3(point, sqrt(max(1.0 - dot(point, point), 0.0)));
    float offset = fract(turn * 16.0 * 0.618034 + float(k) * 0.754878);
    float at_mm = blocked_at_mm(light_ray(position_mm, position, direction), range_mm, samples, offset);
    open += at_mm > range_mm ? 1.0 : at_mm > NEAR * range_mm ? near_share : 0.0;
  }
  return open / float(directions);
}

float direct_reach(vec3 position_mm, vec3 position, vec3 normal, float turn) {
  mat3 frame = frame_along(light_direction);
  float open = 0.0;
  for (int k = 0; k < shadow_rays; ++k) {
    float share = (float(k) + 0.5) / float(shadow_rays);
    vec2 point = turned(vec2(sqrt(share), 0.0), float(k) * 0.381966 + turn) * shadow_spread;
    vec3 direction = normalize(frame * vec3(point, 1.0));
    float offset = fract(turn * 16.0 * 0.618034 + float(k) * 0.754878);
    LightRay ray = light_ray(position_mm, position, direction);
    float at_mm = blocked_at_mm(ray, shadow_range_mm, shadow_samples, offset);
    open += at_mm > shadow_range_mm ? 1.0 : 0.0;
  }
  return open / max(float(shadow_rays), 1.0);
}

void main() {
  reach = vec2(1.0);
  ivec2 first = ivec2(gl_FragCoord.xy) * supersampling;
  vec4 surface = vec4(0.0, 0.0, 0.0, REASON_LEFT_VOLUME);
  for (int i = 0; i < supersampling * supersampling && !holds(surface); ++i)
    surface = texelFetch(surface_texture, first + ivec2(i % supersampling, i / supersampling), 0);
  if (!holds(surface)) return;
  Ray ray = pixel_ray();
  vec3 normal = normal_of(surface);
  // Off the surface, along its normal: what is in the way is sought above it.
  vec3 off_mm = 0.5 * start_mm * normal;
  vec3 position_mm = ray.origin_mm + surface.w * ray.direction + off_mm;
  vec3 position = ray.origin + surface.w * ray.volume_per_mm + patient_to_volume * off_mm;
  float turn = turn_of_pixel();
  if (directions > 0) reach.x = ambient_reach(position_mm, position, normal, turn);
  // What turns away from the light is dark without a shadow, and grazing light would meet the surface's own voxels.
  float facing = smoothstep(0.0, 0.3, dot(normal, light_direction));
  if (shadow_rays > 0) reach.y = mix(1.0, direct_reach(position_mm, position, normal, turn), facing);
}
