// Stacks of another kind that lie between each other in one series.
#pragma once

#include "import/dicom/group.h"

namespace cutaway::reading {

/// Slices of another thickness that lie between each other are two volumes; one behind the other
/// they are one that was taken more finely in one part. So are slices of another image type,
/// description or acquisition where their distances are uneven together and even for themselves.
std::vector<DicomGroup> split_interleaved(const DicomGroup& group);

}  // namespace cutaway::reading
