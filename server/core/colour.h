// Colours between colours.
#pragma once

#include <glm/glm.hpp>

namespace cutaway {

/// Display-encoded sRGB, 0..1, of two such colours: mixed in OKLab, in which equal steps look
/// equal. Source: B. Ottosson, "A perceptual color space for image processing", 2020.
glm::dvec3 mix_colours(glm::dvec3 from, glm::dvec3 to, double share);

/// OKLab of a display-encoded colour: lightness, then the two axes of hue.
glm::dvec3 oklab_of(glm::dvec3 colour);
glm::dvec3 colour_of_oklab(glm::dvec3 oklab);

}  // namespace cutaway
