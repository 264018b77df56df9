// Slices that are there twice.
#pragma once

#include <stop_token>

#include "import/dicom/group.h"

namespace cutaway::reading {

/// Of a group sorted along its normal: leaves out planes that lie where another lies and have the
/// same pixels and values, with a warning. Where what else they say differs, that is done only
/// where no place is left with two planes: else they may be moments of which some look alike.
/// Identifiers do not count, for copies get new ones, and slices that are none share one. A plane
/// whose pixels cannot be compared is no copy.
void leave_out_copies(DicomGroup& group, const std::stop_token& stop);

}  // namespace cutaway::reading
