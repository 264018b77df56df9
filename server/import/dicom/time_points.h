// Moments of an acquisition that no single property parts.
#pragma once

#include "import/dicom/group.h"

namespace cutaway::reading {

/// Parts a group, of which several planes lie at each place, by the order in which they were taken:
/// by acquisition, trigger or content time, or by instance number. A new moment begins where a
/// place comes again; or, where the scanner stayed at a place for all moments, each place's first
/// planes are one moment, its second ones the next. Empty where neither gives stacks.
std::vector<DicomGroup> split_by_moments(const DicomGroup& group);

}  // namespace cutaway::reading
