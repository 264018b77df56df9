// Phong and Blinn-Phong, the control that other styles are compared with.
// Source: B. T. Phong, CACM 18(6), 1975; J. Blinn, SIGGRAPH 1977.

uniform vec3 colour;
uniform float ambient;
uniform float diffuse;
uniform float specular;
uniform float exponent;
uniform bool blinn;

float highlight(vec3 normal, vec3 to_viewer) {
  if (dot(normal, light_direction) <= 0.0) return 0.0;
  if (!blinn) {
    vec3 mirrored = 2.0 * dot(normal, light_direction) * normal - light_direction;
    return pow(max(dot(mirrored, to_viewer), 0.0), exponent);
  }
  vec3 between = light_direction + to_viewer;
  float size = length(between);
  // A Blinn highlight of four times the exponent is about as wide as a Phong one.
  return size > 1e-6 ? pow(max(dot(normal, between / size), 0.0), 4.0 * exponent) : 0.0;
}

vec3 shade(vec3 normal, vec3 to_viewer) {
  float lit = ambient + diffuse * max(dot(normal, light_direction), 0.0);
  return clamp(colour * lit + specular * highlight(normal, to_viewer), 0.0, 1.0);
}
