#version 450 core
// Kuwahara's flattening by sectors of an ellipse that lies along the picture's edges: of eight, each counts the more the
// less its colours vary. Without anisotropy the ellipse is a circle, which is the generalised filter.
//
// The ellipse is looked at in 41 places whatever its size, of a picture that was blurred by about their distance: so it
// costs the same at every resolution. They lie on three rings, of eight directions; a sector has those of its own
// direction and shares those beside it, by the polynomial weights of the third source times a Gaussian over the ellipse.
// Sources: G. Papari, N. Petkov, P. Campisi, IEEE TIP 16(10), 2007; J. E. Kyprianidis, H. Kang, J. Doellner, CGF 28(7),
// 2009; J. E. Kyprianidis, A. Semmo, H. Kang, J. Doellner, TPCG 2010.
#include "filter.glsl"
#include "structure_tensor.glsl"

uniform sampler2D blurred;  // colours multiplied by their weight
uniform sampler2D tensor;
uniform float radius_px;
uniform float anisotropy;
uniform float sharpness;

layout(location = 0) out vec4 filtered;

const int SECTORS = 8;

// Of places on the rings at 1/3, 2/3 and 0.92 of the radius: share of the ellipse that each stands for, times the
// Gaussian there, times the sector's weight. INNER_BESIDE: in the direction beside; HALF: between two directions.
const float CENTRE = 0.125;
const float INNER = 0.4467;
const float INNER_BESIDE = 0.12995;
const float MIDDLE = 0.2494;
const float MIDDLE_HALF = 0.1247;
const float OUTER = 0.0488;
const float OUTER_HALF = 0.0244;
const float ALL_WEIGHTS = CENTRE + INNER + 2.0 * INNER_BESIDE + MIDDLE + 2.0 * MIDDLE_HALF + OUTER + 2.0 * OUTER_HALF;

// Sums over a sector, of colours from the pixel's own.
struct Sector {
  vec4 colours;  // by weight; sum of weights
  vec3 squares;
};

vec3 middle;

void add(inout Sector sector, float weight, vec4 place) {
  vec4 weighed = weight * place.a * vec4(place.rgb, 1.0);
  sector.colours += weighed;
  sector.squares += weighed.rgb * place.rgb;
}

// Colour from the middle's, and its weight.
vec4 place_at(ivec2 pixel, vec2 offset) {
  ivec2 at = pixel + ivec2(floor(offset + 0.5));
  vec4 colour = is_in_picture(at) ? texelFetch(blurred, at, 0) : vec4(0.0);
  return vec4(colour.rgb / max(colour.a, 1e-6) - middle, colour.a);
}

// A sector of which little is covered says little.
float weight_of(Sector sector) {
  float share = sector.colours.a / ALL_WEIGHTS;
  float all = max(sector.colours.a, 1e-9);
  vec3 mean = sector.colours.rgb / all;
  vec3 deviation = sqrt(max(sector.squares / all - mean * mean, 0.0));
  float uneven = 255.0 * (deviation.r + deviation.g + deviation.b);
  float calm = 1.0 / (1.0 + exp2(sharpness * log2(max(uneven, 1e-6))));
  return calm * max(share - 0.25, 1e-3 * share);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 centre = texelFetch(colour_texture, pixel, 0);
  filtered = centre;
  if (centre.a == 0.0 || radius_px == 0.0) return;
  vec4 here = texelFetch(blurred, pixel, 0);
  middle = here.rgb / max(here.a, 1e-6);

  Flow flow = Flow(vec2(1.0, 0.0), 0.0);
  if (anisotropy > 0.0) flow = flow_of(texelFetch(tensor, pixel, 0));
  float stretch = 1.0 + anisotropy * flow.coherence;
  vec2 along = radius_px * stretch * flow.along;
  vec2 across = radius_px / stretch * vec2(-flow.along.y, flow.along.x);

  vec4 own = vec4(0.0, 0.0, 0.0, here.a);
  Sector sectors[SECTORS];
  for (int i = 0; i < SECTORS; ++i) {
    sectors[i] = Sector(vec4(0.0), vec3(0.0));
    add(sectors[i], CENTRE, own);
  }
  for (int i = 0; i < SECTORS; ++i) {
    float angle = 0.785398163 * float(i);
    vec2 ahead = cos(angle) * along + sin(angle) * across;
    vec2 between = cos(angle + 0.392699082) * along + sin(angle + 0.392699082) * across;
    int next = (i + 1) % SECTORS;
    vec4 inner = place_at(pixel, ahead / 3.0);
    add(sectors[i], INNER, inner);
    add(sectors[next], INNER_BESIDE, inner);
    add(sectors[(i + 7) % SECTORS], INNER_BESIDE, inner);
    add(sectors[i], MIDDLE, place_at(pixel, 2.0 / 3.0 * ahead));
    add(sectors[i], OUTER, place_at(pixel, 0.92 * ahead));
    vec4 middle_between = place_at(pixel, 2.0 / 3.0 * between);
    add(sectors[i], MIDDLE_HALF, middle_between);
    add(sectors[next], MIDDLE_HALF, middle_between);
    vec4 outer_between = place_at(pixel, 0.92 * between);
    add(sectors[i], OUTER_HALF, outer_between);
    add(sectors[next], OUTER_HALF, outer_between);
  }

  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < SECTORS; ++i) {
    float weight = weight_of(sectors[i]);
    sum += weight * sectors[i].colours.rgb / max(sectors[i].colours.a, 1e-9);
    weights += weight;
  }
  filtered.rgb = clamp(middle + sum / max(weights, 1e-30), 0.0, 1.0);
}
