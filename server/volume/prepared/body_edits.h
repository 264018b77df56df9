// What the body mask changes of a volume.
#pragma once

#include <stop_token>

#include "volume/facts/body_mask.h"
#include "volume/volume.h"

namespace cutaway {

/// Sets what is not the body nor its skin's rim to `air`, physical.
void hide_couch(Volume& volume, const BodyMask& mask, double air, const std::stop_token& stop);

/// Raises what lies well within the body's outline to at least `value`: lungs and bowel have no
/// surface any more.
void fill_body(Volume& volume, const BodyMask& mask, double value, const std::stop_token& stop);

}  // namespace cutaway
