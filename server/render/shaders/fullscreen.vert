#version 450 core
#include "viewport_triangle.glsl"

void main() { gl_Position = behind_everything(viewport_corner()); }
