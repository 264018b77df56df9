// A band whose material lets light through: how much of it lies between two samples, and how much light it takes.

uniform vec2 opacities;  // of one millimetre of material, by branch; 1: opaque from its surface on

// What is behind so little cannot be seen in eight bits.
const float LEAST_TRANSMITTANCE = 0.002;

// The part of the way between two samples (0..1) along which a value that changes linearly lies in the band; empty where
// it never does. So no band is too thin for the step.
vec2 share_in_band(vec2 band, float near_value, float far_value) {
  float rise = far_value - near_value;
  if (abs(rise) < 1e-9) return vec2(0.0, band_side(band, near_value) == IN_BAND ? 1.0 : 0.0);
  float at_lower = (band.x - near_value) / rise;
  float at_upper = (band.y - near_value) / rise;
  return clamp(vec2(min(at_lower, at_upper), max(at_lower, at_upper)), 0.0, 1.0);
}

// Opacity of a length of material, from that of one millimetre.
float opacity_over(int branch, float length_mm) { return 1.0 - pow(1.0 - opacities[branch], length_mm); }
