// Vertebrae of chest and loins.
#pragma once

#include "volume/phantom/shape.h"

namespace cutaway::phantom {

struct VertebraMeasures {
  glm::vec3 centre_mm{0.0f};  ///< of the body
  glm::vec3 half_body_mm{24, 17, 13};
  float spinous_mm = 30.0f;      ///< length of the spinous process behind the canal
  float spinous_drop_mm = 6.0f;  ///< how far its tip lies below its root
  float transverse_mm = 40.0f;   ///< reach of the transverse processes from the midline
};

ShapePtr vertebra(const VertebraMeasures& measures);

/// The disc between two vertebrae.
ShapePtr disc(const VertebraMeasures& above, const VertebraMeasures& below);

}  // namespace cutaway::phantom
