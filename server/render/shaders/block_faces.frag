#version 450 core
// How far along its ray a face is met.
#include "view.glsl"

in vec3 position_mm;

layout(location = 0) out float entry_mm;

void main() {
  vec3 from_eye = position_mm - eye_mm;
  entry_mm = is_perspective ? length(from_eye) : dot(from_eye, view_forward);
}
