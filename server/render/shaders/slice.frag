#version 450 core
// A plane of the volume by window and level. A pixel is the mean of supersampling^2 points.

#include "pixel_ray.glsl"
#include "volume.glsl"

uniform float black;     // the stored value drawn so
uniform float per_grey;  // 1 over the stored values from black to white
uniform int supersampling;

layout(location = 0) out vec4 picture;

float grey_at(vec3 position) {
  bool is_inside = all(greaterThanEqual(position, vec3(0.0))) && all(lessThanEqual(position, vec3(1.0)));
  return is_inside ? clamp((stored_value(position) - black) * per_grey, 0.0, 1.0) : 0.0;
}

void main() {
  float rays = float(supersampling);
  float sum = 0.0;
  for (int y = 0; y < supersampling; ++y) {
    for (int x = 0; x < supersampling; ++x) {
      vec2 beside = (vec2(x, y) + 0.5) / rays - 0.5;
      sum += grey_at(from_in_volume(in_picture(gl_FragCoord.xy + beside)));
    }
  }
  picture = vec4(vec3(sum / (rays * rays)), 1.0);
}
