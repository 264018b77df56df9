// Strokes of ink whose share of the paper is the darkness of what they stand for: ink lies where noise that runs along
// the strokes is below the darkness' rank. The noise is normally distributed everywhere, so that ranks are known
// without a look at other pixels, and bound to the picture, so that a stroke grows and shrinks with the light but never
// moves.
// Source of noise from wavelets on a lattice: A. Lagae, S. Lefebvre, G. Drettakis, P. Dutre, "Procedural Noise using
// Sparse Gabor Convolution", SIGGRAPH 2009; of strokes whose density is the tone: G. Winkenbach, D. Salesin,
// "Computer-Generated Pen-and-Ink Illustration", SIGGRAPH 1994.

uniform float width_px;   // of a stroke where half of the paper is ink
uniform float length_px;  // of a stroke
uniform vec2 first_px;    // of this part, in the whole picture
uniform float angle;      // of the parallel family, in radians, anticlockwise
uniform float cross_from;
uniform float wall_darker;
uniform vec3 ink;
uniform vec3 paper;
uniform float wash;
uniform float strength;

const float TURN = 6.2831853;
const float CROSSED_BY = 1.134;  // 65 degrees: squarer crossings shimmer as a chequerboard
const uint FIRST = 1u;
const uint SECOND = 2u;

// M. E. O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms", 2014.
uint scrambled(uint state) {
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uint hash_of(ivec2 cell, uint family) { return scrambled(uint(cell.x) + scrambled(uint(cell.y) + scrambled(family))); }

// In 0..1, neither of which it is.
float share_of(uint bits) { return (float(bits & 0x3ffu) + 0.5) / 1024.0; }

// A wavelet's height, so distributed that its value is a normal number at any phase.
float height_of(uint hash) { return sqrt(-2.0 * log(share_of(hash))); }

// Squares of the windows of all cells about a place add up to one.
float window(vec2 offset) { return cos(0.25 * TURN * offset.x) * cos(0.25 * TURN * offset.y); }

// Of parallel strokes: `at` along and across them, in cells of a stroke's length and two widths.
float parallel_noise(vec2 at, uint family) {
  ivec2 first = ivec2(floor(at));
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 cell = first + ivec2(i & 1, i >> 1);
    vec2 offset = at - vec2(cell);
    uint hash = hash_of(cell, family);
    sum += window(offset) * height_of(hash) * cos(TURN * (offset.y + share_of(hash >> 10u)));
  }
  return sum;
}

vec2 direction_of(float angle) { return vec2(cos(angle), -sin(angle)); }

float parallel_strokes(vec2 pixel, float angle, uint family) {
  vec2 along = direction_of(angle);
  vec2 across = vec2(-along.y, along.x);
  vec2 place = pixel + first_px;
  return parallel_noise(vec2(dot(place, along) / (0.6 * length_px), dot(place, across) / (2.0 * width_px)), family);
}

// The number below which a normal one lies with that probability.
// Source: S. Winitzki, "A Handy Approximation for the Error Function and its Inverse", 2008.
float normal_below(float share) {
  float x = 2.0 * clamp(share, 1e-5, 1.0 - 1e-5) - 1.0;
  float log_of = log(1.0 - x * x);
  float half_way = 4.3307467 + 0.5 * log_of;
  return 1.4142136 * sign(x) * sqrt(sqrt(half_way * half_way - log_of / 0.147) - half_way);
}

// How much of a pixel is ink where strokes are to cover that share. A stroke's edge is about a pixel wide; that blurs
// the noise's distribution by a known variance.
float inked(float noise, float share) {
  float edge = 1.2 * 0.5 * TURN / width_px;
  float limit = normal_below(share) * sqrt(1.0 + edge * edge / 12.0);
  float covered = clamp(0.5 + (limit - noise) / edge, 0.0, 1.0);
  return share <= 0.0 ? 0.0 : share >= 1.0 ? 1.0 : covered;
}

// The shares of two families that together cover `share`: the second begins where the first has got to `alone`.
vec2 shares_of(float share, float alone) {
  float first = min(share, alone);
  return vec2(first, 1.0 - (1.0 - share) / max(1.0 - first, 1e-6));
}

// The lens' wall is crossed from the first stroke on.
vec2 shares_of_wall(float share) { return vec2(1.0 - sqrt(max(1.0 - share, 0.0))); }

float both(float first, float second) { return 1.0 - (1.0 - first) * (1.0 - second); }

float wall_strokes(vec2 pixel, float darkness) {
  vec2 shares = shares_of_wall(mix(darkness, 1.0, wall_darker));
  return both(inked(parallel_strokes(pixel, angle + 0.611, FIRST), shares.x),
              inked(parallel_strokes(pixel, angle - 0.524, SECOND), shares.y));
}

vec3 drawn(vec3 colour, float covered) { return mix(colour, mix(mix(paper, colour, wash), ink, covered), strength); }
