// The flexible tone shader: from two flat tones (detail 0) to a smooth ramp (detail 1). A piece of length detail/2 of each
// end of the ramp from dark to light is stretched over its half of the lit range.

struct Tone {
  vec3 dark;
  vec3 light;
  float detail;
  float terminator;  // half-Lambert: the cosine that stands in the middle of the ramp
  bool half_lambert;
};
uniform Tone tone[2];  // by branch

// Half-Lambert lights the side away from the light too; clamped leaves it flat and has the middle of the ramp at 60 degrees.
float ramp_position(Tone tone, float cosine) {
  if (!tone.half_lambert) return clamp(cosine, 0.0, 1.0);
  float from_terminator = cosine - tone.terminator;
  float reach = from_terminator < 0.0 ? 1.0 + tone.terminator : 1.0 - tone.terminator;
  return clamp(0.5 + 0.5 * from_terminator / reach, 0.0, 1.0);
}

float stitched(float detail, float u) { return u < 0.5 ? detail * u : 1.0 - detail * (1.0 - u); }

vec3 shade_tone(int branch, vec3 normal, vec3 to_viewer, float light_share) {
  float u = ramp_position(tone[branch], dot(normal, light_direction)) * light_share;
  return mix(tone[branch].dark, tone[branch].light, stitched(tone[branch].detail, u));
}
