#version 450 core
// Fifth: which way strokes run, the direction on the surface in which its normal turns most, seen by the camera. In the
// surface's own plane the products of the normal's derivatives are the square of its shape operator, whose greatest
// eigenvalue belongs to the direction of the greatest curvature. Where the surface is near flat, or curved alike every
// way, the parallel family's direction takes over.
#include "filter.glsl"
#include "structure_tensor.glsl"

uniform sampler2D forms;
uniform sampler2D tensor;
uniform float angle;
uniform float length_px;

layout(location = 0) out vec4 flow;  // x, y, unit; 1 where there is one; 0

const float STEEPEST = 0.15;  // of a normal to the viewer, beyond which the picture says little
const float ALIKE = 0.5;      // difference of the curvatures' squares, as a share of their sum
const float FLAT = 0.25;      // angle by which a near flat surface turns along a stroke

// Of the symmetric matrix xx, xy, yy.
mat2 matrix_of(vec3 t) { return mat2(t.x, t.y, t.y, t.z); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 form = texelFetch(forms, pixel, 0);
  vec4 summed = texelFetch(tensor, pixel, 0);
  float facing = clamp(form.z, STEEPEST, 1.0);
  vec2 slope = form.xy / max(length(form.xy), 1e-6);
  // From lengths on the surface to lengths in the picture, and back.
  mat2 seen = mat2(1.0) + (facing - 1.0) * outerProduct(slope, slope);
  mat2 unseen = mat2(1.0) + (1.0 / facing - 1.0) * outerProduct(slope, slope);
  mat2 squares = seen * matrix_of(summed.xyz / max(summed.w, 1e-6)) * seen;
  float all = squares[0][0] + squares[1][1];
  float apart = length(vec2(squares[0][0] - squares[1][1], 2.0 * squares[0][1])) / max(all, 1e-12);
  float flat_turn = FLAT / length_px;
  float lost = all * max(ALIKE - apart, 0.0) + max(flat_turn * flat_turn - all, 0.0);
  vec2 usual = normalize(unseen * vec2(cos(angle), -sin(angle)));
  squares += lost * outerProduct(usual, usual);
  Flow least = flow_of(vec4(squares[0][0], squares[0][1], squares[1][1], 1.0));
  vec2 way = seen * vec2(-least.along.y, least.along.x);
  flow = form.w * vec4(way / max(length(way), 1e-6), 1.0, 0.0);
}
