#include "core/colour.h"

#include <cmath>

namespace cutaway {

namespace {

double to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double to_encoded(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// Columns of the matrices between linear sRGB, the eye's three cones and OKLab.
const glm::dmat3 kConesOfLinear(0.4122214708, 0.2119034982, 0.0883024619,  //
                                0.5363325363, 0.6806995451, 0.2817188376,  //
                                0.0514459929, 0.1073969566, 0.6299787005);
const glm::dmat3 kLabOfCones(0.2104542553, 1.9779984951, 0.0259040371,   //
                             0.7936177850, -2.4285922050, 0.7827717662,  //
                             -0.0040720468, 0.4505937099, -0.8086757660);

}  // namespace

glm::dvec3 oklab_of(glm::dvec3 colour) {
  const glm::dvec3 linear(to_linear(colour.r), to_linear(colour.g), to_linear(colour.b));
  const glm::dvec3 cones = kConesOfLinear * linear;
  return kLabOfCones * glm::dvec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

glm::dvec3 colour_of_oklab(glm::dvec3 oklab) {
  const glm::dvec3 roots = glm::inverse(kLabOfCones) * oklab;
  const glm::dvec3 linear = glm::inverse(kConesOfLinear) * (roots * roots * roots);
  return glm::clamp(glm::dvec3(to_encoded(linear.r), to_encoded(linear.g), to_encoded(linear.b)),
                    0.0, 1.0);
}

glm::dvec3 mix_colours(glm::dvec3 from, glm::dvec3 to, double share) {
  return colour_of_oklab(glm::mix(oklab_of(from), oklab_of(to), share));
}

}  // namespace cutaway
