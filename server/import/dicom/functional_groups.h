// Enhanced multi-frame DICOM: what each frame says of itself.
// Source: DICOM PS3.3, C.7.6.16 "Multi-frame Functional Groups Module".
#pragma once

#include <gdcmDataSet.h>

#include "import/dicom/frame.h"

namespace cutaway::reading {

bool has_functional_groups(const gdcm::DataSet& data);

/// One frame per item of the per-frame groups; what an item leaves out comes from the shared
/// groups. `common` brings what holds for the whole file. Throws Error naming the file where a
/// frame has no position, orientation or pixel measures, or where NumberOfFrames disagrees.
std::vector<DicomFrame> enhanced_frames(const DicomFrame& common, const gdcm::DataSet& data);

}  // namespace cutaway::reading
