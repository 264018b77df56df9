// The bands of values that make up the two branches' material.

uniform vec2 lower_limits;  // stored units, by branch
uniform vec2 upper_limits;  // NO_UPPER_LIMIT: larger than any value

const float NO_UPPER_LIMIT = 3e38;

// Where a value lies: below the band, in it, above it.
const int BELOW = -1;
const int IN_BAND = 0;
const int ABOVE = 1;

int band_side(int branch, float value) {
  return value <= lower_limits[branch] ? BELOW : value >= upper_limits[branch] ? ABOVE : IN_BAND;
}

vec3 index_along(Ray ray, float distance_mm) { return ray.origin_index + distance_mm * ray.index_per_mm; }

float value_along(Ray ray, float distance_mm) { return stored_value(index_along(ray, distance_mm)); }
