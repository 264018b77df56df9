// How fast the brightness under the narrower Gaussian changes, by Sobel's kernels. Where the branch has nothing, and on the
// other side of the lens' rim, the pixel's own brightness goes on.

uniform sampler2D scales;

float near_at(ivec2 pixel, Scales here) {
  pixel = clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1);
  Scales there = scales_of(texelFetch(scales, pixel, 0));
  return there.is_covered && there.side == here.side ? there.near : here.near;
}

// Per pixel, across and down.
vec2 brightness_slope(ivec2 pixel) {
  Scales here = scales_of(texelFetch(scales, pixel, 0));
  float n[9];
  for (int i = 0; i < 9; ++i) n[i] = near_at(pixel + ivec2(i % 3 - 1, i / 3 - 1), here);
  return 0.125 * vec2((n[2] + 2.0 * n[5] + n[8]) - (n[0] + 2.0 * n[3] + n[6]),
                      (n[6] + 2.0 * n[7] + n[8]) - (n[0] + 2.0 * n[1] + n[2]));
}
