// Enhanced multi-frame DICOM: what each frame says of itself.
// Source: DICOM PS3.3, C.7.6.16 "Multi-frame Functional Groups Module".
#pragma once

#include "import/dicom/data_set.h"
#include "import/dicom/frame.h"

namespace cutaway::reading {

bool has_functional_groups(const DataSet& data);

/// One frame per item of the per-frame groups; what an item leaves out comes from the shared
/// groups, and what those leave out from the top level, where some writers put it. Throws Error
/// naming the file where a frame has no position, orientation or pixel measures, or where
/// NumberOfFrames disagrees.
std::vector<DicomFrame> enhanced_frames(DicomImage image, const DataSet& data);

}  // namespace cutaway::reading
