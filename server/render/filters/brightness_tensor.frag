#version 450 core
// The structure tensor of the brightness under the narrower Gaussian; see structure_tensor.frag.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "brightness_slope.glsl"

layout(location = 0) out vec4 tensor;  // xx, xy, yy, 1; all 0 where the branch has nothing

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 slope = brightness_slope(pixel);
  float is_covered = texelFetch(scales, pixel, 0).w;
  tensor = is_covered * vec4(slope.x * slope.x, slope.x * slope.y, slope.y * slope.y, 1.0);
}
