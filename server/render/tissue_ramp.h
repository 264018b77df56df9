// The colours in which an anatomical section is drawn, by value.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "volume/loaded_volume.h"

namespace cutaway {

inline constexpr int kTissueColours = 65;  ///< TISSUES of shaders/wall.glsl

struct TissueRamp {
  ValueRange range;  ///< physical values of the first and the last colour
  std::array<glm::vec3, kTissueColours> colours;  ///< display-encoded sRGB, evenly over the range
};

/// In Hounsfield units fat, muscle and bone have their own; other values run through them over the
/// range that the volume's values usually lie in.
TissueRamp tissue_ramp(const LoadedVolume& loaded);

}  // namespace cutaway
