// The way in which a picture changes least, from its smoothed structure tensor (structure_tensor.frag).
// Source: J. Bigun, G. Granlund, "Optimal Orientation Detection of Linear Symmetry", ICCV 1987.

struct Flow {
  vec2 along;       // unit, of a line: its sign means nothing
  float coherence;  // 0: no way more than another; 1: an ideal edge
};

// So little change is noise that has no direction.
const float NO_CHANGE = 1e-5;

Flow flow_of(vec4 tensor) {
  vec3 t = tensor.xyz / max(tensor.a, 1e-6);
  float root = sqrt((t.x - t.z) * (t.x - t.z) + 4.0 * t.y * t.y);
  float most = 0.5 * (t.x + t.z + root);
  vec2 along = vec2(most - t.x, -t.y);
  float size = length(along);
  return Flow(size > 1e-12 ? along / size : vec2(0.0, 1.0), root / (t.x + t.z + NO_CHANGE));
}
