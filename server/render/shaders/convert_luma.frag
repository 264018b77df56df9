#version 450 core
#include "ycbcr.glsl"

layout(location = 0) out float luma;

// Where the plane is larger than the picture, the last column and row repeat: JPEG wants whole chroma blocks.
void main() {
  ivec2 pixel = min(ivec2(gl_FragCoord.xy), textureSize(picture, 0) - 1);
  luma = dot(texelFetch(picture, pixel, 0).rgb, TO_Y);
}
