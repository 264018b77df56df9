// NRRD headers and data for tests, written from the format's definition, so that the reader is
// checked against that.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace cutaway::test::nrrd {

inline constexpr glm::ivec3 kSize(4, 3, 5);
/// LPS: i to posterior, j down, k to the left.
inline const glm::dmat3 kSteps(0, 1.5, 0, 0, 0, -2, 2.5, 0, 0);
inline const glm::dvec3 kOrigin(-10, 20, 35.5);

/// Of a ramp in short, in the given space; `flip` takes LPS to it. Without the empty line that ends
/// it.
std::string header(const std::string& space, glm::dvec3 flip, const std::string& encoding,
                   const std::string& rest = "");

std::string ramp_bytes(bool big_endian = false);

std::string text_of_ramp();

std::string hex_of(const std::string& bytes);

}  // namespace cutaway::test::nrrd
