// What the steps of the lines along gaps in depth hand on.

// A line's begin: a pixel that lies before a gap, or that nothing lies behind.
struct Begin {
  float reach_sq;      // the line's width squared, less the square of the distance so far; below 0: no line gets here
  float width_px;
  float behind_mm;     // what lies farther away than this is not before the gap
};

const vec4 NO_BEGIN = vec4(-1e9, 0.0, 0.0, 0.0);

Begin begin_of(vec4 texel) { return Begin(texel.x, texel.y, texel.z); }
