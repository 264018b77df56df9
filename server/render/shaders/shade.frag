#version 450 core
// Turns one branch's surface into colour: a program for each BRANCH and each shading model, whose file and function are
// defined. Each pixel averages supersampling^2 surface samples.

#include "branches.glsl"
#include "light.glsl"
#include "view_ray.glsl"
#include SHADING_FILE

uniform sampler2D surface_texture;
uniform int supersampling;

layout(location = 0) out vec4 shaded;               // display-encoded colour, not premultiplied; coverage
layout(location = 1) out float silhouette_coverage;  // coverage as if no lens had taken anything away

void main() {
  vec2 size_px = vec2(textureSize(surface_texture, 0));
  ivec2 first = ivec2(gl_FragCoord.xy) * supersampling;
  vec3 colour_sum = vec3(0.0);
  float held = 0.0;
  float taken_by_lens = 0.0;
  for (int y = 0; y < supersampling; ++y) {
    for (int x = 0; x < supersampling; ++x) {
      ivec2 pixel = first + ivec2(x, y);
      vec4 surface = texelFetch(surface_texture, pixel, 0);
      if (holds(surface)) {
        vec3 to_viewer = -view_direction(vec2(pixel) + 0.5, size_px);
        colour_sum += SHADE(BRANCH, normal_of(surface), to_viewer);
        held += 1.0;
      } else if (surface.w == REASON_OTHER_BRANCH) {
        taken_by_lens += 1.0;
      }
    }
  }
  float samples = float(supersampling * supersampling);
  shaded = vec4(colour_sum / max(held, 1.0), held / samples);
  silhouette_coverage = (held + taken_by_lens) / samples;
}
