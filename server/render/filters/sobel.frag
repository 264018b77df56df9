#version 450 core
// Sobel edges of the branch's colour, brightness, depth or normals, and of its coverage for true silhouettes: the coverage
// is taken as if no lens had cut anything away, and what is seen through the lens is not compared with what is not: the
// lens' rim is not a line of the anatomy.
// Source: I. Sobel, G. Feldman 1968, in R. Duda, P. Hart, "Pattern Classification and Scene Analysis", 1973.
#include "branches.glsl"
#include "filter.glsl"

layout(location = 0) out vec4 filtered;

uniform float strength;
uniform int mode;
uniform int source;
uniform bool silhouettes;
uniform float depth_step_mm;  // counts as a step of one
uniform float gain;           // 1: raw; 1/4: a unit step along an axis gives 1
uniform bool euclidean;

const int DARKEN = 0;
const int BRIGHTEN = 1;
const int MULTIPLY = 2;

const int SOURCE_LUMA = 1;
const int SOURCE_DEPTH = 2;

// Means over the rays of a pixel that meet the branch.
struct Met {
  vec3 normal;
  float depth_mm;
  float behind_lens;  // share of them
};

Met met_at(ivec2 pixel) {
  bool is_asked = is_cut || source >= SOURCE_DEPTH;
  int rays = is_asked ? supersampling * supersampling : 0;
  Met sum = Met(vec3(0.0), 0.0, 0.0);
  float met = 0.0;
  for (int i = 0; i < rays; ++i) {
    ivec2 ray = ivec2(i % supersampling, i / supersampling);
    vec4 surface = texelFetch(surface_texture, pixel * supersampling + ray, 0);
    float weight = holds(surface) ? 1.0 : 0.0;
    sum.normal += weight * normal_of(surface);
    sum.depth_mm += weight * surface.w;
    sum.behind_lens += weight * (lies_behind_lens(surface) ? 1.0 : 0.0);
    met += weight;
  }
  met = max(met, 1.0);
  return Met(sum.normal / met, sum.depth_mm / met, sum.behind_lens / met);
}

// What is compared: three components, and the share of the rays behind the lens, which must agree. Multiplying takes the
// edges of the brightness for those of the colour.
vec4 feature_at(ivec2 pixel, vec4 colour) {
  Met met = met_at(pixel);
  vec3 feature = mode == MULTIPLY ? vec3(brightness(colour.rgb)) : colour.rgb;
  if (source == SOURCE_LUMA) feature = vec3(brightness(colour.rgb));
  if (source == SOURCE_DEPTH) feature = vec3(met.depth_mm / depth_step_mm);
  if (source > SOURCE_DEPTH) feature = met.normal;
  return vec4(feature, met.behind_lens);
}

// The feature and the silhouette coverage. The feature is the centre's where the branch has none, so that only the coverage
// tells, and on the other side of the lens' rim, of which one ray in four is enough.
vec4 neighbour(ivec2 pixel, vec4 centre) {
  pixel = clamp(pixel, ivec2(0), textureSize(colour_texture, 0) - 1);
  vec4 colour = texelFetch(colour_texture, pixel, 0);
  vec4 feature = colour.a > 0.0 ? feature_at(pixel, colour) : centre;
  if (abs(feature.w - centre.w) > 0.2) feature = centre;
  return vec4(feature.xyz, silhouettes ? texelFetch(silhouette_texture, pixel, 0).r : 1.0);
}

// Clamped before it is scaled: the strength is how black a strong line gets, not a gain.
vec4 edges(ivec2 pixel, vec4 centre) {
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
