// The ray of a pixel, in patient space (mm) and in the volume's texture coordinates; see corner_rays.glsl.

noperspective in vec3 from_mm;
noperspective in vec3 toward_mm;
noperspective in vec3 from_in_volume;
noperspective in vec3 toward_in_volume;

struct Ray {
  vec3 origin_mm;      // patient space
  vec3 direction;      // patient space, unit
  vec3 origin;         // in the volume
  vec3 volume_per_mm;  // direction in the volume
};

// An exact zero would make 0 * infinity in tests against planes.
vec3 away_from_zero(vec3 direction) { return mix(direction, vec3(1e-10), lessThan(abs(direction), vec3(1e-10))); }

Ray pixel_ray() {
  float per_mm = inversesqrt(dot(toward_mm, toward_mm));
  return Ray(from_mm, toward_mm * per_mm, from_in_volume, away_from_zero(toward_in_volume * per_mm));
}
