// What filters that draw lines from the brightness hand on: the brightness under two Gaussians, of the pixels that the branch
// covers, and only of those on the pixel's own side of the lens' rim, which is no line.

struct Scales {
  float near;   // under the narrower Gaussian
  float wide;   // under one WIDER times as wide
  float side;   // 1: seen through the cutaway's lens
  bool is_covered;
};

const float WIDER = 1.6;  // D. Marr, E. Hildreth, "Theory of Edge Detection", 1980

Scales scales_of(vec4 texel) { return Scales(texel.x, texel.y, texel.z, texel.w > 0.0); }

int wide_reach(float sigma) { return int(ceil(2.5 * WIDER * sigma)); }

float gaussian(float offset, float sigma) { return exp(-0.5 * offset * offset / max(sigma * sigma, 1e-6)); }

// Which side of the lens' rim most of the pixel's rays see.
float side_of(ivec2 pixel) {
  float behind = 0.0;
  int rays = is_cut ? supersampling * supersampling : 0;
  for (int i = 0; i < rays; ++i) {
    ivec2 ray = pixel * supersampling + ivec2(i % supersampling, i / supersampling);
    behind += lies_behind_lens(texelFetch(surface_texture, ray, 0)) ? 1.0 : 0.0;
  }
  return 2.0 * behind > float(rays) ? 1.0 : 0.0;
}
