#version 450 core
// Kuwahara's edge-preserving flattening: of the four windows that have the pixel in a corner, the mean colour of the one
// whose brightness varies least; of several that vary equally little, the average, so that ramps do not shift. A pixel
// weighs as much as the branch covers it.
//
// Neighbours share their windows, so each is worked out once: sums of rows, windows of rows, and here the choice.
// Source: M. Kuwahara et al., "Processing of RI-angiocardiographic images", 1976.
#include "filter.glsl"
#include "kuwahara.glsl"

uniform sampler2D windows;

layout(location = 0) out vec4 filtered;

const float TIE = 1e-6;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  vec4 around[4];
  float least = 1e9;
  for (int i = 0; i < 4; ++i) {
    around[i] = texelFetch(windows, pixel + radius_px * ivec2(i % 2, i / 2), 0);
    least = min(least, around[i].a);
  }
  vec3 mean_sum = vec3(0.0);
  float chosen = 0.0;
  for (int i = 0; i < 4; ++i) {
    float weight = around[i].a <= least + TIE ? 1.0 : 0.0;
    mean_sum += weight * around[i].rgb;
    chosen += weight;
  }
  bool is_asked = centre.a > 0.0 && radius_px > 0;
  filtered = is_asked ? vec4(mean_sum / chosen, centre.a) : centre;
}
