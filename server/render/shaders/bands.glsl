// The bands of values that make up the two branches' material.

const float NO_UPPER_LIMIT = 3e38;

// Where a value lies: below the band, in it, above it.
const int BELOW = -1;
const int IN_BAND = 0;
const int ABOVE = 1;

vec2 band_of(int branch) { return branch == FOCUS ? all_rays.focus_band : all_rays.context_band; }

int band_side(vec2 band, float value) { return value <= band.x ? BELOW : value >= band.y ? ABOVE : IN_BAND; }
