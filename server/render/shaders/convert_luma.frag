#version 450 core
#include "ycbcr.glsl"

layout(location = 0) out float luma;

void main() { luma = dot(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, TO_Y); }
