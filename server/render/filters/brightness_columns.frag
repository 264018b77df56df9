#version 450 core
// Second step of filters over brightness.glsl: means, from the sums along rows.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"

uniform sampler2D row_sums;
uniform float sigma_px;

layout(location = 0) out vec4 scales;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float side = side_of(pixel);
  int reach = wide_reach(sigma_px);
  vec4 sums = vec4(0.0);
  for (int y = max(-reach, -pixel.y); y <= min(reach, textureSize(colour_texture, 0).y - 1 - pixel.y); ++y) {
    ivec2 there = pixel + ivec2(0, y);
    vec2 both = vec2(gaussian(float(y), sigma_px), gaussian(float(y), WIDER * sigma_px));
    sums += (side_of(there) == side ? 1.0 : 0.0) * both.xxyy * texelFetch(row_sums, there, 0);
  }
  float is_covered = texelFetch(colour_texture, pixel, 0).a > 0.0 ? 1.0 : 0.0;
  scales = vec4(sums.xz / max(sums.yw, 1e-9), side, is_covered);
}
