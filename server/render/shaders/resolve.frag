#version 450 core
// Turns one branch's accumulated layers into a picture: each pixel averages supersampling^2 rays. The counterpart of
// shade.frag where the rays have been shaded already.

#include "branches.glsl"

uniform sampler2D surface_texture;
uniform sampler2D layers_texture;  // premultiplied colour and opacity, a texel a ray
uniform int supersampling;

layout(location = 0) out vec4 shaded;               // display-encoded colour, not premultiplied; coverage
layout(location = 1) out float silhouette_coverage;  // coverage as if no lens had taken anything away

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * supersampling;
  vec4 sum = vec4(0.0);
  float inside_outline = 0.0;
  for (int y = 0; y < supersampling; ++y) {
    for (int x = 0; x < supersampling; ++x) {
      sum += texelFetch(layers_texture, first + ivec2(x, y), 0);
      vec4 surface = texelFetch(surface_texture, first + ivec2(x, y), 0);
      if (holds(surface) || surface.w == REASON_OTHER_BRANCH) inside_outline += 1.0;
    }
  }
  float rays = float(supersampling * supersampling);
  shaded = vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), sum.a / rays);
  silhouette_coverage = inside_outline / rays;
}
