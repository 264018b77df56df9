#version 450 core
// Turns one branch's surface into colour: a program for each BRANCH, each shading model, whose file and function are
// defined, and each number of rays a pixel: it averages SUPERSAMPLING^2 of them.

#include "branches.glsl"
#include "light.glsl"
#include "pixel_ray.glsl"
#include SHADING_FILE

uniform sampler2D surface_texture;

layout(location = 0) out vec4 shaded;               // display-encoded colour, not premultiplied; coverage
layout(location = 1) out float silhouette_coverage;  // coverage as if no lens had taken anything away

// Of the ray through a part of the pixel.
vec3 to_viewer(ivec2 part) {
  vec2 off_centre = (vec2(part) + 0.5) / float(SUPERSAMPLING) - 0.5;
  return -normalize(toward_mm(in_picture(gl_FragCoord.xy + off_centre)));
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * SUPERSAMPLING;
  vec3 colour_sum = vec3(0.0);
  float held = 0.0;
  float taken_by_lens = 0.0;
  for (int y = 0; y < SUPERSAMPLING; ++y) {
    for (int x = 0; x < SUPERSAMPLING; ++x) {
      vec4 surface = texelFetch(surface_texture, first + ivec2(x, y), 0);
      vec3 colour = SHADE(BRANCH, normal_of(surface), to_viewer(ivec2(x, y)));
      colour_sum += holds(surface) ? colour : vec3(0.0);
      held += holds(surface) ? 1.0 : 0.0;
      taken_by_lens += surface.w == REASON_OTHER_BRANCH ? 1.0 : 0.0;
    }
  }
  float samples = float(SUPERSAMPLING * SUPERSAMPLING);
  shaded = vec4(colour_sum / max(held, 1.0), held / samples);
  silhouette_coverage = (held + taken_by_lens) / samples;
}
