#version 450 core
// Chroma averaged over blocks of BLOCK_PX each way, as JPEG sites it; at odd sizes the last column and row repeat.
#include "ycbcr.glsl"

layout(location = 0) out float cb;
layout(location = 1) out float cr;

void main() {
  ivec2 last = textureSize(picture, 0) - 1;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < BLOCK_PX; ++y) {
    for (int x = 0; x < BLOCK_PX; ++x) {
      sum += texelFetch(picture, min(ivec2(gl_FragCoord.xy) * BLOCK_PX + ivec2(x, y), last), 0).rgb;
    }
  }
  vec3 mean = sum / float(BLOCK_PX * BLOCK_PX);
  // 128/255, so that grey is the byte 128 exactly.
  cb = dot(mean, TO_CB) + 128.0 / 255.0;
  cr = dot(mean, TO_CR) + 128.0 / 255.0;
}
