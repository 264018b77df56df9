#version 450 core
// The Magic Lens: the focus blended over the context with a weight that falls from the lens' middle to its rim. Weights add
// up to one; where the focus is empty the context keeps all of it, else a hole to the background would open.
// Paradigm: E. Bier et al., "Toolglass and Magic Lenses: The See-Through Interface", SIGGRAPH 1993; in three dimensions
// J. Viega et al., "3D Magic Lenses", UIST 1996.

#include "pixel_ray.glsl"
#include "lens.glsl"

uniform sampler2D context_colour;
uniform sampler2D focus_colour;
uniform vec3 background_colour;
uniform float lens_strength;
uniform float lens_softness;
uniform bool lens_strict;  // the context fades where the focus is empty, too

layout(location = 0) out vec4 picture;

float focus_weight(float offset) {
  if (1.0 - lens_softness >= 1.0) return offset < 1.0 ? lens_strength : 0.0;
  return lens_strength * (1.0 - smoothstep(1.0 - lens_softness, 1.0, offset));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 context = texelFetch(context_colour, pixel, 0);
  vec4 focus = texelFetch(focus_colour, pixel, 0);
  Ray ray = pixel_ray();
  float weight = focus_weight(lens_offset(ray.origin_mm, ray.direction));
  vec3 without_lens = mix(background_colour, context.rgb, context.a);
  vec3 behind_focus = lens_strict ? background_colour : without_lens;
  picture = vec4(mix(without_lens, mix(behind_focus, focus.rgb, focus.a), weight), 1.0);
}
