// A Gaussian in one direction, of texels that are multiplied by their weight, which is in alpha: what has no weight, and what
// lies beyond the picture, does not count.

uniform ivec2 along;     // (1, 0) or (0, 1)
uniform float sigma_px;  // in pixels of the picture

int blur_reach(float sigma) { return int(ceil(2.5 * sigma)); }

float blur_weight(int offset, float sigma) { return exp(-0.5 * float(offset * offset) / max(sigma * sigma, 1e-6)); }

// Of a texel's place beside the middle one; divides by all weights, also those of what lies beyond.
float blur_sum(float sigma) {
  float sum = 1.0;
  for (int i = 1; i <= blur_reach(sigma); ++i) sum += 2.0 * blur_weight(i, sigma);
  return sum;
}
