// The approximating cubic B-spline of a copy of the volume: the stored samples are its coefficients, so that it needs no
// volume of its own, and neither its value nor its slope has a kink between voxels. 64 samples give both at once.
// Source: C. Sigg, M. Hadwiger, "Fast Third-Order Texture Filtering", GPU Gems 2, 2005.

struct Spline {
  float value;
  vec3 slope;  // per texel
};

// Of four neighbouring samples, where `t` is the place between the second and the third.
vec4 spline_weights(float t) {
  float u = 1.0 - t;
  return vec4(u * u * u, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * u * u * (2.0 - u), t * t * t) / 6.0;
}

vec4 spline_slopes(float t) {
  float u = 1.0 - t;
  return vec4(-u * u, t * (3.0 * t - 4.0), u * (4.0 - 3.0 * u), t * t) / 2.0;
}

// Beyond the outermost samples the volume goes on as steeply as it comes there: what such a sample would weigh falls on the
// two before it.
vec4 folded(vec4 weights, int first, int count) {
  if (first < 0) weights = vec4(0.0, weights.y + 2.0 * weights.x, weights.z - weights.x, weights.w);
  if (first + 3 >= count) weights = vec4(weights.x, weights.y - weights.w, weights.z + 2.0 * weights.w, 0.0);
  return weights;
}

// Positions are texture coordinates of the volume, `from_volume` as in coarse_volume.glsl.
Spline spline_at(sampler3D samples, vec3 from_volume, vec3 position) {
  ivec3 count = textureSize(samples, 0);
  vec3 place = clamp(position * from_volume * vec3(count) - 0.5, vec3(0.0), vec3(count - 1));
  ivec3 below = clamp(ivec3(place), ivec3(0), max(count - 2, ivec3(0)));
  vec3 t = place - vec3(below);
  ivec3 first = below - 1;
  vec4 weights[3];
  vec4 slopes[3];
  for (int axis = 0; axis < 3; ++axis) {
    weights[axis] = folded(spline_weights(t[axis]), first[axis], count[axis]);
    slopes[axis] = folded(spline_slopes(t[axis]), first[axis], count[axis]);
  }
  ivec4 columns = clamp(first.x + ivec4(0, 1, 2, 3), 0, count.x - 1);
  Spline sum = Spline(0.0, vec3(0.0));
  for (int i = 0; i < 16; ++i) {
    ivec2 at = ivec2(i & 3, i >> 2);
    ivec2 row = clamp(first.yz + at, ivec2(0), count.yz - 1);
    vec4 values = vec4(texelFetch(samples, ivec3(columns.x, row), 0).r, texelFetch(samples, ivec3(columns.y, row), 0).r,
                       texelFetch(samples, ivec3(columns.z, row), 0).r, texelFetch(samples, ivec3(columns.w, row), 0).r);
    float value = dot(values, weights[0]);
    float y = weights[1][at.x];
    float z = weights[2][at.y];
    sum.value += value * y * z;
    sum.slope += vec3(dot(values, slopes[0]) * y * z, value * slopes[1][at.x] * z, value * y * slopes[2][at.y]);
  }
  return sum;
}
