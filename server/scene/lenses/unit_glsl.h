// What a unit body's GLSL file needs to be C++; included by those files' twins only.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

// They define what unit_body.glsl lists, whether this body needs all of it or not.
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace cutaway::unit_glsl {

using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using glm::dot;
using glm::length;
using glm::max;
using glm::min;
using glm::sign;
using std::abs;
using std::sqrt;

}  // namespace cutaway::unit_glsl
