// The window to begin with.
#pragma once

#include "import/dicom/group.h"

namespace cutaway::reading {

/// Of the slice nearest to the middle that has one: end slices may be empty, with windows to match.
std::optional<ValueRange> window_of_middle(const DicomGroup& group);

/// Takes the window out of the description, with a warning, where next to none of the values lie
/// in it, so that it would show black and white alone.
void leave_out_useless_window(RawVolume& raw);

}  // namespace cutaway::reading
