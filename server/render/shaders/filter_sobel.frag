#version 450 core
// Sobel edges of the branch's colour, brightness, depth or normals, and of its coverage for true silhouettes: the coverage
// is taken as if no lens had cut anything away, since the lens' rim is not a line of the anatomy.
// Source: I. Sobel, G. Feldman 1968, in R. Duda, P. Hart, "Pattern Classification and Scene Analysis", 1973.
#include "branches.glsl"
#include "filter.glsl"

uniform float strength;
uniform int mode;
uniform int source;
uniform bool silhouettes;
uniform float depth_step_mm;  // counts as a step of one
uniform float gain;           // 1: raw; 1/4: a unit step along an axis gives 1
uniform bool euclidean;

const int DARKEN = 0;
const int BRIGHTEN = 1;

const int SOURCE_LUMA = 1;
const int SOURCE_DEPTH = 2;

// Mean depth (in steps) or normal of the rays of a pixel that meet the branch.
vec3 surface_feature(ivec2 pixel) {
  ivec2 rays = textureSize(surface_texture, 0) / textureSize(colour_texture, 0);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < rays.x * rays.y; ++i) {
    vec4 surface = texelFetch(surface_texture, pixel * rays + ivec2(i % rays.x, i / rays.x), 0);
    vec3 feature = source == SOURCE_DEPTH ? vec3(surface.w / depth_step_mm) : surface.xyz;
    if (holds(surface)) sum += vec4(feature, 1.0);
  }
  return sum.xyz / max(sum.w, 1.0);
}

vec3 feature_at(ivec2 pixel, vec4 colour) {
  if (source < SOURCE_LUMA) return colour.rgb;
  return source == SOURCE_LUMA ? vec3(brightness(colour.rgb)) : surface_feature(pixel);
}

// The feature and the silhouette coverage; the centre's feature where the branch has none, so that only the coverage tells.
vec4 neighbour(ivec2 pixel, vec3 centre) {
  pixel = clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1);
  vec4 colour = texelFetch(colour_texture, pixel, 0);
  vec3 feature = colour.a > 0.0 ? feature_at(pixel, colour) : centre;
  return vec4(feature, silhouettes ? texelFetch(silhouette_texture, pixel, 0).r : 1.0);
}

// Clamped before it is scaled: the strength is how black a strong line gets, not a gain.
vec4 edges(ivec2 pixel, vec3 centre) {
  vec4 n[9];
  for (int i = 0; i < 9; ++i) n[i] = neighbour(pixel + ivec2(i % 3 - 1, i / 3 - 1), centre);
  vec4 across = (n[2] + 2.0 * n[5] + n[8]) - (n[0] + 2.0 * n[3] + n[6]);
  vec4 down = (n[6] + 2.0 * n[7] + n[8]) - (n[0] + 2.0 * n[1] + n[2]);
  vec4 magnitude = euclidean ? sqrt(across * across + down * down) : abs(across) + abs(down);
  return min(gain * magnitude, vec4(1.0));
}

// Coloured lines only from colour: a normal's three components are no colours.
vec3 lines_of(vec4 edge) {
  vec3 lines = source >= SOURCE_DEPTH ? vec3(max(max(edge.x, edge.y), edge.z)) : edge.rgb;
  return max(lines, vec3(edge.a));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || strength == 0.0) return;
  vec3 lines = lines_of(edges(pixel, feature_at(pixel, centre)));
  if (mode == DARKEN) {
    filtered.rgb = centre.rgb - strength * lines;
  } else if (mode == BRIGHTEN) {
    filtered.rgb = centre.rgb + strength * lines;
  } else {
    filtered.rgb = centre.rgb * (1.0 - strength * brightness(lines));
  }
  filtered.rgb = clamp(filtered.rgb, 0.0, 1.0);
}
