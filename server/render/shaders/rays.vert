#version 450 core
#include "corner_rays.glsl"

void main() { put_corner(); }
