// What Kuwahara's steps share. Sums and windows lie `radius_px` further right and down than the pixels they begin at, since
// windows begin up to a radius outside of the picture.

uniform int radius_px;

// Brightness against the middle: E[y^2]-E[y]^2 loses its digits near white.
float offset_of(vec3 colour) { return brightness(colour) - 0.5; }

// By which windows are chosen: the variance of a window's brightness. One with less than a quarter of its pixels covered
// says little; it comes after all others, and the better covered first.
const float LITTLE = 1000.0;  // above any variance

float unevenness(float variance, float covered) {
  float enough = 0.25 * float((radius_px + 1) * (radius_px + 1));
  return covered >= enough ? variance : LITTLE * (2.0 - covered / enough);
}
