// The ray of a pixel, in patient space (mm) and in the volume's texture coordinates. It is made from the pixel's place in
// the whole picture, a number that floats hold exactly, and not interpolated: so it is the same whatever part is drawn.
#ifndef HANDED
#define HANDED in
#endif
#include "pixel_rays.glsl"

struct Ray {
  vec3 origin_mm;      // patient space
  vec3 direction;      // patient space, unit
  vec3 origin;         // in the volume
  vec3 volume_per_mm;  // direction in the volume
};

// An exact zero would make 0 * infinity in tests against planes.
vec3 away_from_zero(vec3 direction) { return mix(direction, vec3(1e-10), lessThan(abs(direction), vec3(1e-10))); }

// Of a point among the fragments: -1..1, y down. Row 0 of the picture is the upper row, and the lower one of the viewport.
vec2 in_picture(vec2 fragment) { return (fragment + pixel_rays.place.xy) * pixel_rays.place.zw - 1.0; }

vec3 across_mm(vec2 at) { return at.x * pixel_rays.right_mm - at.y * pixel_rays.up_mm; }

vec3 across_in_volume(vec2 at) { return at.x * pixel_rays.right_in_volume - at.y * pixel_rays.up_in_volume; }

// Not of unit length.
vec3 toward_mm(vec2 at) { return pixel_rays.toward_mm + pixel_rays.shifts.y * across_mm(at); }

vec3 from_in_volume(vec2 at) { return pixel_rays.from_in_volume + pixel_rays.shifts.x * across_in_volume(at); }

Ray ray_through(vec2 fragment) {
  vec2 at = in_picture(fragment);
  vec3 toward = toward_mm(at);
  vec3 toward_in_volume = pixel_rays.toward_in_volume + pixel_rays.shifts.y * across_in_volume(at);
  float per_mm = inversesqrt(dot(toward, toward));
  return Ray(pixel_rays.from_mm + pixel_rays.shifts.x * across_mm(at), toward * per_mm, from_in_volume(at),
             away_from_zero(toward_in_volume * per_mm));
}

Ray pixel_ray() { return ray_through(gl_FragCoord.xy); }
