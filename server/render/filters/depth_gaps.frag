#version 450 core
// First of the depth lines' four steps: where the branch's surface lies before a gap, and how wide its line begins. A gap is
// what a step in depth between two pixels has beyond the slopes on either side of it: a slope that goes on, however steep,
// is none, nor are the rings of slices, which are a flight of like steps where a surface turns away. A rim that a lens has cut is none either (see branches.glsl).
#include "branches.glsl"
#include "filter.glsl"
#include "depth_lines.glsl"

uniform float width_px;
uniform float thinnest;     // width at the smallest gap, as a share
uniform float gap_mm;       // from which on there is a line
uniform float full_gap_mm;  // from which on it has its full width
uniform bool silhouettes;
uniform int flight_px;      // how far off steps of a flight are

layout(location = 0) out vec4 begin;

const float NO_DEPTH = -1.0;
const float ENDLESS = 1e9;

struct Met {
  float depth_mm;     // of its nearest ray; NO_DEPTH: none meets the branch
  float behind_lens;  // share of them
  float share;        // of all rays, those that meet it
};

Met met_at(ivec2 pixel) {
  float nearest_mm = ENDLESS;
  float met = 0.0;
  float behind = 0.0;
  bool is_asked = is_in_picture(pixel);
  for (int i = 0; i < supersampling * supersampling && is_asked; ++i) {
    vec4 surface = texelFetch(surface_texture, pixel * supersampling + ivec2(i % supersampling, i / supersampling), 0);
    float weight = holds(surface) ? 1.0 : 0.0;
    nearest_mm = min(nearest_mm, holds(surface) ? surface.w : ENDLESS);
    behind += weight * (lies_behind_lens(surface) ? 1.0 : 0.0);
    met += weight;
  }
  return Met(met > 0.0 ? nearest_mm : NO_DEPTH, behind / max(met, 1.0), met / float(supersampling * supersampling));
}

// How much farther away `there` is than `here`; 0 where nothing is, `across_rim` where the lens' rim lies between.
float fall(Met here, Met there, float across_rim) {
  if (here.depth_mm < 0.0 || there.depth_mm < 0.0) return 0.0;
  return abs(there.behind_lens - here.behind_lens) > 0.2 ? across_rim : there.depth_mm - here.depth_mm;
}

// The steepest fall from pixel to pixel on a way that begins with `here`, going `way`; `sign` -1: it comes from there.
float steepest(ivec2 pixel, Met here, ivec2 way, float sign) {
  float most = 0.0;
  for (int i = 1; i <= flight_px; ++i) {
    Met next = met_at(pixel + i * way);
    most = max(most, sign * fall(here, next, i == 1 ? sign * ENDLESS : 0.0));
    here = next;
  }
  return most;
}

// Beside the rim the slope is not known, and a lens' wall begins steeply there.
float gap_towards(ivec2 pixel, Met here, ivec2 way) {
  ivec2 next = pixel + way;
  Met there = met_at(next);
  bool is_outline = silhouettes && is_in_picture(next) && there.depth_mm < 0.0 &&
                    texelFetch(silhouette_texture, next, 0).r == 0.0;
  if (is_outline) return ENDLESS;
  float gap = fall(here, there, 0.0);
  if (gap <= gap_mm) return 0.0;
  return gap - steepest(pixel, here, -way, -1.0) - steepest(next, there, way, 1.0);
}

// The line fades in over half of the smallest gap, so that none comes and goes with noise.
float width_for(float gap) {
  float grown = clamp((gap - gap_mm) / max(full_gap_mm - gap_mm, 1e-3), 0.0, 1.0);
  float faded = clamp((gap - gap_mm) / (0.5 * gap_mm), 0.0, 1.0);
  return width_px * faded * mix(thinnest, 1.0, grown);
}

// A pixel that the surface's edge crosses shows of its ink the share that the surface has of it: the line is as much
// wider, so that it has its width from the edge on in a small picture, too.
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Met here = met_at(pixel);
  begin = NO_BEGIN;
  if (here.depth_mm < 0.0) return;
  float gap = max(max(gap_towards(pixel, here, ivec2(1, 0)), gap_towards(pixel, here, ivec2(-1, 0))),
                  max(gap_towards(pixel, here, ivec2(0, 1)), gap_towards(pixel, here, ivec2(0, -1))));
  float width = width_for(gap);
  if (width > 0.0) width += 1.0 - here.share;
  if (width > 0.0) begin = vec4(width * width, width, here.depth_mm + 0.5 * min(gap, full_gap_mm), 0.0);
}
