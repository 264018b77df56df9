#version 450 core
// Takes a branch's normals anew, of the volume under a Gaussian: weighted differences across PAIRS directions around each
// hit, on a copy of the volume that is so coarse that the taps lie densely. Source of the idea: S. Marschner, R. Lobb, "An
// Evaluation of Reconstruction Filters for Volume Rendering", IEEE Visualization 1994; the tap sets are our own.

#include "branches.glsl"
#include "pixel_ray.glsl"
#include "volume.glsl"
#include "coarse_volume.glsl"

uniform sampler2D surface_texture;
uniform vec3 pair_offset[PAIRS];    // to one of a pair's taps; the other lies opposite
uniform vec3 pair_gradient[PAIRS];  // what a rise of two from the one to the other means, patient space, per mm

layout(location = 0) out vec4 calmed;

// How much of an offset stays within the volume, where beyond its outermost centres nothing rises any more.
float share_within(vec3 position, vec3 offset) {
  vec3 first = 0.5 * voxel_size;
  vec3 last = 1.0 - first;
  vec3 room = mix(first - position, last - position, greaterThan(offset, vec3(0.0)));
  vec3 shares = room / mix(offset, vec3(1e-12), lessThan(abs(offset), vec3(1e-12)));
  shares = mix(shares, vec3(1.0), lessThan(abs(offset), vec3(1e-12)));
  return clamp(min(min(shares.x, shares.y), shares.z), 0.0, 1.0);
}

vec3 gradient_at(vec3 position) {
  vec3 gradient = vec3(0.0);
  for (int i = 0; i < PAIRS; ++i) {
    float ahead = share_within(position, pair_offset[i]);
    float behind = share_within(position, -pair_offset[i]);
    float rise = coarse_value(position + ahead * pair_offset[i]) - coarse_value(position - behind * pair_offset[i]);
    gradient += rise / max(ahead + behind, 0.02) * pair_gradient[i];
  }
  return gradient;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(surface_texture, texel, 0);
  calmed = surface;
  if (!holds(surface) || is_cut_face(surface)) return;
  Ray ray = pixel_ray();
  vec3 gradient = gradient_at(ray.origin + surface.w * ray.volume_per_mm);
  float steepness = length(gradient);
  if (steepness < 1e-12) return;
  // Of the wide gradient the line, of the narrow one the side: where a part is thinner than the Gaussian the wide one sees
  // its other face. Not turned towards the viewer, whom a calm normal may lose sight of at an outline.
  vec3 normal = -gradient / steepness;
  calmed.xyz = length_of_place(surface) * (dot(normal, surface.xyz) < 0.0 ? -normal : normal);
}
