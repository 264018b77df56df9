// The flexible tone shader: from two flat tones (detail 0) to a smooth ramp (detail 1). A piece of length detail/2 of each
// end of the ramp from dark to light is stretched over its half of the lit range.

uniform vec3 dark;
uniform vec3 light;
uniform float detail;
uniform float terminator;  // half-Lambert: the cosine that stands in the middle of the ramp
uniform bool half_lambert;

// Half-Lambert lights the side away from the light too; clamped leaves it flat and has the middle of the ramp at 60 degrees.
float ramp_position(float cosine) {
  if (!half_lambert) return clamp(cosine, 0.0, 1.0);
  float from_terminator = cosine - terminator;
  float reach = from_terminator < 0.0 ? 1.0 + terminator : 1.0 - terminator;
  return clamp(0.5 + 0.5 * from_terminator / reach, 0.0, 1.0);
}

float stitched(float u) { return u < 0.5 ? detail * u : 1.0 - detail * (1.0 - u); }

vec3 shade(vec3 normal, vec3 to_viewer) {
  return mix(dark, light, stitched(ramp_position(dot(normal, light_direction))));
}
