#version 450 core
// Puts the branches over the background. Under the cutaway's rule each sample belongs to one branch at most, so their
// coverages add up and no order is needed.

uniform sampler2D context_colour;
uniform sampler2D focus_colour;
uniform vec3 background_colour;

layout(location = 0) out vec4 picture;

void main() {
  vec4 context = texelFetch(context_colour, ivec2(gl_FragCoord.xy), 0);
  vec4 focus = texelFetch(focus_colour, ivec2(gl_FragCoord.xy), 0);
  float uncovered = 1.0 - context.a - focus.a;
  picture = vec4(context.a * context.rgb + focus.a * focus.rgb + uncovered * background_colour, 1.0);
}
