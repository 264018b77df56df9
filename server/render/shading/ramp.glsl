// Six colours from the side away from the light to the one towards it. What lies in shadow moves down the ramp, into its
// cool end, instead of towards black. The colours between are worked out in OKLab before, so that the ramp is even to the
// eye. Source: B. Ottosson, "A perceptual color space for image processing", 2020.

const int RAMP_COLOURS = 81;  // sixteen from one to the next

struct Ramp {
  vec3 colours[RAMP_COLOURS];
  float gamma;
  float step_share;
  float step_begin;
  float step_end;
};
uniform Ramp ramp[2];  // by branch

vec3 shade_ramp(int branch, vec3 normal, vec3 to_viewer, float light_share) {
  float term = pow(clamp(0.5 + 0.5 * dot(normal, light_direction), 0.0, 1.0), ramp[branch].gamma) * light_share;
  float stepped = smoothstep(ramp[branch].step_begin, ramp[branch].step_end, term);
  float at = mix(term, stepped, ramp[branch].step_share) * float(RAMP_COLOURS - 1);
  int below = min(int(at), RAMP_COLOURS - 2);
  return mix(ramp[branch].colours[below], ramp[branch].colours[below + 1], at - float(below));
}
