// Noise from integer hashes: the same on every machine.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace cutaway::phantom {

/// A well-mixed 32-bit value of a lattice point (the finaliser is that of MurmurHash3, A. Appleby,
/// public domain).
inline std::uint32_t lattice_hash(glm::ivec3 point, std::uint32_t seed) {
  std::uint32_t h = std::uint32_t(point.x) * 0x8da6b343u ^ std::uint32_t(point.y) * 0xd8163841u ^
                    std::uint32_t(point.z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// Gradient noise in about -1..1 with features of about one unit, smooth to the second derivative.
/// Source: K. Perlin, "Improving Noise", SIGGRAPH 2002.
float gradient_noise(glm::vec3 position, std::uint32_t seed);

/// Three independent gradient noises, to displace a position by.
glm::vec3 gradient_noise3(glm::vec3 position, std::uint32_t seed);

}  // namespace cutaway::phantom
