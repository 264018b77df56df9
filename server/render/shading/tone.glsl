// The flexible tone shader: from two flat tones (detail 0) to a smooth ramp (detail 1). A piece of length detail/2 of each
// end of the ramp from dark to light is stretched over its half of the lit range.

struct Tone {
  vec3 dark;
  vec3 light;
  float detail;
  float terminator;  // half-Lambert: the cosine that stands in the middle of the ramp
  bool half_lambert;
  float softness_rays;  // of the step, its width: at least 1; only where it is known how normals turn
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

// Share of a square of side 1 that lies on the lit side of a line: its middle's distance from the line, lit side positive,
// and the line's normal.
float lit_share(float distance, vec2 normal) {
  float longer = max(abs(normal.x), abs(normal.y));
  float shorter = min(abs(normal.x), abs(normal.y));
  float aside = abs(distance);
  float beyond = max(0.5 * (longer + shorter) - aside, 0.0);
  float corner = beyond * beyond / max(2.0 * longer * shorter, 1e-6);
  float share = aside < 0.5 * (longer - shorter) ? 0.5 - aside / longer : corner;
  return distance < 0.0 ? share : 1.0 - share;
}

// The same where it is known how the normal turns from ray to ray: the step is as wide as the softness says, so that its
// stairs are gone. Its distance is that of the cosine from the step's, over the length of the cosine's gradient: the sum of
// its parts (fwidth) would be wrong by up to 41 % where the boundary lies aslant.
// What lies in shadow is on the dark side, too, with a border as soft as the shadow's.
vec3 shade_tone_turning(int branch, vec3 normal, vec3 to_viewer, float light_share, mat2x3 turning) {
  float cosine = dot(normal, light_direction);
  vec2 a_ray = light_direction * turning;
  float per_ray = length(a_ray);
  float from_step = cosine - (tone[branch].half_lambert ? tone[branch].terminator : 0.5);
  float hard = from_step < 0.0 ? 0.0 : 1.0;
  float away = from_step / max(per_ray * tone[branch].softness_rays, 1e-20);
  float lit = per_ray > 0.0 ? lit_share(away, a_ray / per_ray) : hard;
  float u = ramp_position(tone[branch], cosine) * light_share;
  if (light_share < 1.0) lit = min(lit, clamp(0.5 + 20.0 * (u - 0.5), 0.0, 1.0));
  float detail = tone[branch].detail;
  return mix(tone[branch].dark, tone[branch].light, mix(detail * u, 1.0 - detail * (1.0 - u), lit));
}
