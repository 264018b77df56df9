#version 450 core
// Kuwahara's edge-preserving flattening: of the four quadrants of the window that hold the centre, the mean colour of the
// one whose brightness varies least; of several that vary equally little, the average, so that ramps do not shift. A pixel
// weighs as much as the branch covers it.
// Source: M. Kuwahara et al., "Processing of RI-angiocardiographic images", 1976.
#include "filter.glsl"

uniform int radius_px;

const float TIE = 1e-6;

struct Quadrant {
  vec3 colour_sum;
  float offset_sum;          // brightness against the centre's: E[y^2]-E[y]^2 loses its digits near white
  float offset_squared_sum;
  float samples;             // sum of weights
};

// Pixels outside of the picture weigh nothing. A negative radius looks at none.
Quadrant gather(ivec2 centre, ivec2 direction, int radius, float centre_brightness) {
  Quadrant quadrant = Quadrant(vec3(0.0), 0.0, 0.0, 0.0);
  for (int y = 0; y <= radius; ++y) {
    for (int x = 0; x <= radius; ++x) {
      ivec2 pixel = centre + direction * ivec2(x, y);
      vec4 colour = texelFetch(colour_texture, clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1), 0);
      float weight = is_in_picture(pixel) ? colour.a : 0.0;
      float offset = brightness(colour.rgb) - centre_brightness;
      quadrant.colour_sum += weight * colour.rgb;
      quadrant.offset_sum += weight * offset;
      quadrant.offset_squared_sum += weight * offset * offset;
      quadrant.samples += weight;
    }
  }
  return quadrant;
}

float variance(Quadrant quadrant) {
  float mean = quadrant.offset_sum / quadrant.samples;
  return max(quadrant.offset_squared_sum / quadrant.samples - mean * mean, 0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  bool is_asked = centre.a > 0.0 && radius_px > 0;
  int radius = is_asked ? radius_px : -1;  // in software the loops then end at once

  Quadrant quadrants[4];
  float variances[4];
  float least = 1e9;
  // A quadrant with less than a quarter of its samples covered says little; the centre alone always leaves one.
  float enough = 0.25 * float((radius_px + 1) * (radius_px + 1));
  float most_samples = 0.0;
  for (int i = 0; i < 4; ++i) {
    quadrants[i] = gather(pixel, ivec2(i % 2 == 0 ? -1 : 1, i < 2 ? -1 : 1), radius, brightness(centre.rgb));
    variances[i] = variance(quadrants[i]);
    most_samples = max(most_samples, quadrants[i].samples);
  }
  enough = min(enough, most_samples);
  for (int i = 0; i < 4; ++i) {
    if (quadrants[i].samples >= enough) least = min(least, variances[i]);
  }
  vec3 mean_sum = vec3(0.0);
  float chosen = 0.0;
  for (int i = 0; i < 4; ++i) {
    if (quadrants[i].samples < enough || variances[i] > least + TIE) continue;
    mean_sum += quadrants[i].colour_sum / quadrants[i].samples;
    chosen += 1.0;
  }
  filtered = is_asked ? vec4(mean_sum / chosen, centre.a) : centre;
}
