// Gooch's warm-to-cool shading: the side towards the light tends to yellow, the other to blue, each with a share of the
// surface's own colour. Source: A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for
// Automatic Technical Illustration", SIGGRAPH 1998 (there with the light vector the other way round).

struct Gooch {
  vec3 colour;
  float blue;
  float yellow;
  float alpha;  // share of the colour in the cool tone
  float beta;   // share of the colour in the warm tone
};
uniform Gooch gooch[2];  // by branch

vec3 shade_gooch(int branch, vec3 normal, vec3 to_viewer, float light_share) {
  vec3 cool = vec3(0.0, 0.0, gooch[branch].blue) + gooch[branch].alpha * gooch[branch].colour;
  vec3 warm = vec3(gooch[branch].yellow, gooch[branch].yellow, 0.0) + gooch[branch].beta * gooch[branch].colour;
  float towards_light = clamp(0.5 + 0.5 * dot(normal, light_direction), 0.0, 1.0) * light_share;
  return clamp(mix(cool, warm, towards_light), 0.0, 1.0);
}
