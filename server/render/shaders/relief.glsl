// What light that is kept away, and the lens' cavity, make of a shaded point.

uniform sampler2D reach_texture;   // see light_reach.frag
uniform float occlusion_strength;
uniform vec3 occlusion_colour;     // the share of its colour that a point keeps which no light reaches
uniform float shadow_strength;

vec2 reach_at(ivec2 pixel) { return texelFetch(reach_texture, pixel, 0).rg; }

float share_of_light(vec2 reach) { return 1.0 - shadow_strength * (1.0 - reach.y); }

vec3 occluded(vec3 colour, vec2 reach) {
  return colour * mix(vec3(1.0), mix(occlusion_colour, vec3(1.0), reach.x), occlusion_strength);
}
