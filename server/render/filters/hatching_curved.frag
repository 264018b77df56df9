#version 450 core
// Last: strokes along the flow, the mean of the noise on a pixel's way along it; a family of its own for the lens'
// wall.
// Source: B. Cabral, L. Leedom, "Imaging Vector Fields Using Line Integral Convolution", SIGGRAPH 1993; of strokes
// along curvature: V. Interrante, "Illustrating Surface Shape in Volume Data via Principal Direction-Driven 3D Line
// Integral Convolution", SIGGRAPH 1997.
#include "branches.glsl"
#include "filter.glsl"
#include "brightness.glsl"
#include "hatching.glsl"

uniform sampler2D flows;
uniform sampler2D noises;
uniform int steps;         // each way
uniform float step_px;
uniform float deviation;   // of the mean along a way

layout(location = 0) out vec4 filtered;

// Beyond the picture's edge it is mirrored.
float noise_at(ivec2 at, int family) {
  ivec2 last = textureSize(noises, 0) - 1;
  return texelFetch(noises, clamp(last - abs(last - abs(at)), ivec2(0), last), 0)[family];
}

vec2 turned(vec2 way, float by) { return mat2(cos(by), sin(by), -sin(by), cos(by)) * way; }

// Beyond the surface the way goes straight on: a stroke ends, but the noise does not. The way is counted from the
// pixel, so that it is rounded alike in whatever part of the picture the pixel lies.
float along(ivec2 pixel, vec2 way, float by, int family) {
  ivec2 last = textureSize(flows, 0) - 1;
  vec2 gone = vec2(0.5);
  float sum = 0.0;
  for (int i = 1; i <= steps; ++i) {
    gone += step_px * way;
    ivec2 at = pixel + ivec2(floor(gone));
    float fade = cos(0.25 * TURN * float(i) / float(steps + 1));
    sum += fade * fade * noise_at(at, family);
    vec4 flow = texelFetch(flows, clamp(at, ivec2(0), last), 0);
    vec2 next = turned(flow.xy, by);
    next = dot(next, way) < 0.0 ? -next : next;
    way = flow.z > 0.0 && dot(next, way) > 0.5 ? next : way;
  }
  return sum;
}

float curved_strokes(ivec2 pixel, vec2 way, float by, int family) {
  vec2 first = turned(way, by);
  float sum = noise_at(pixel, family) + along(pixel, first, by, family) + along(pixel, -first, by, family);
  return sum / deviation;
}

float surface_strokes(ivec2 pixel, vec2 way, float darkness) {
  vec2 shares = shares_of(darkness, cross_from);
  float first = inked(curved_strokes(pixel, way, 0.0, 0), shares.x);
  if (shares.y <= 0.0) return first;
  return both(first, inked(curved_strokes(pixel, way, CROSSED_BY, 1), shares.y));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || width_px == 0.0) return;
  float darkness = 1.0 - brightness(centre.rgb);
  vec4 flow = texelFetch(flows, pixel, 0);
  vec2 way = flow.z > 0.0 ? flow.xy : direction_of(angle);
  bool is_wall = side_of(pixel) == 1.0;
  float covered = is_wall ? wall_strokes(gl_FragCoord.xy, darkness) : surface_strokes(pixel, way, darkness);
  filtered.rgb = drawn(centre.rgb, covered);
}
