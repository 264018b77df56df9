#version 450 core
// The brightness gathered about a few levels, from black to white, with soft edges between them; colours keep their hue.
// Source: H. Winnemoeller, S. Olsen, B. Gooch, "Real-Time Video Abstraction", SIGGRAPH 2006. Here the curve has no jump at
// any hardness: in the middle between two edges, what comes from either side is the same.
#include "filter.glsl"

uniform int bins;
uniform float hardness;

layout(location = 0) out vec4 filtered;

void main() {
  vec4 centre = texelFetch(colour_texture, ivec2(gl_FragCoord.xy), 0);
  float before = brightness(centre.rgb);
  float place = before * float(bins);
  float edge = clamp(floor(place + 0.5), 1.0, float(bins - 1));
  float beside = clamp(tanh(hardness * (place - edge)) / tanh(0.5 * hardness), -1.0, 1.0);
  float after = (edge - 0.5 + 0.5 * beside) / float(bins - 1);
  vec3 colour = before > 0.0 ? centre.rgb * (after / before) : centre.rgb;
  filtered = vec4(clamp(colour, 0.0, 1.0), centre.a);
}
