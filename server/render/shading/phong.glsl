// Phong and Blinn-Phong, the control that other styles are compared with.
// Source: B. T. Phong, CACM 18(6), 1975; J. Blinn, SIGGRAPH 1977.

struct Phong {
  vec3 colour;
  float ambient;
  float diffuse;
  float specular;
  float exponent;
  bool blinn;
};
uniform Phong phong[2];  // by branch

float highlight(Phong phong, vec3 normal, vec3 to_viewer) {
  if (dot(normal, light_direction) <= 0.0) return 0.0;
  if (!phong.blinn) {
    vec3 mirrored = 2.0 * dot(normal, light_direction) * normal - light_direction;
    return pow(max(dot(mirrored, to_viewer), 0.0), phong.exponent);
  }
  vec3 between = light_direction + to_viewer;
  float size = length(between);
  // A Blinn highlight of four times the exponent is about as wide as a Phong one.
  return size > 1e-6 ? pow(max(dot(normal, between / size), 0.0), 4.0 * phong.exponent) : 0.0;
}

vec3 shade_phong(int branch, vec3 normal, vec3 to_viewer, float light_share) {
  float lit = phong[branch].ambient + phong[branch].diffuse * light_share * max(dot(normal, light_direction), 0.0);
  float shining = phong[branch].specular * light_share * highlight(phong[branch], normal, to_viewer);
  return clamp(phong[branch].colour * lit + shining, 0.0, 1.0);
}
