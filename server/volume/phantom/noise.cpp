#include "volume/phantom/noise.h"

namespace cutaway::phantom {

namespace {

/// Dot product with one of the twelve directions to a cube's edges.
float slope(std::uint32_t hash, glm::vec3 offset) {
  const std::uint32_t h = hash & 15u;
  const float u = h < 8 ? offset.x : offset.y;
  const float v = h < 4 ? offset.y : (h == 12 || h == 14 ? offset.x : offset.z);
  return ((h & 1u) ? -u : u) + ((h & 2u) ? -v : v);
}

float mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

float gradient_noise(glm::vec3 position, std::uint32_t seed) {
  const glm::vec3 base = glm::floor(position);
  const glm::ivec3 cell(base);
  const glm::vec3 f = position - base;
  const glm::vec3 fade = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const auto corner = [&](int x, int y, int z) {
    return slope(lattice_hash(cell + glm::ivec3(x, y, z), seed), f - glm::vec3(x, y, z));
  };
  const auto along_x = [&](int y, int z) { return mix(corner(0, y, z), corner(1, y, z), fade.x); };
  const auto along_y = [&](int z) { return mix(along_x(0, z), along_x(1, z), fade.y); };
  return mix(along_y(0), along_y(1), fade.z);
}

glm::vec3 gradient_noise3(glm::vec3 position, std::uint32_t seed) {
  return {gradient_noise(position, seed), gradient_noise(position, seed + 101u),
          gradient_noise(position, seed + 202u)};
}

}  // namespace cutaway::phantom
