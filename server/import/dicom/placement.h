// Where a plane lies, and when it was taken. Source: DICOM PS3.3, C.7.6.2.
#pragma once

#include "import/dicom/data_set.h"
#include "import/dicom/frame.h"

namespace cutaway::reading {

/// Position, orientation, spacing and thickness of `frame` out of the first of `groups` that has
/// each. Throws Error naming the file and `whose` where one is absent or no finite numbers.
void place(DicomFrame& frame, const std::string& whose, const std::vector<DataSet>& groups);

/// Seconds of "HHMMSS.FFFFFF", "YYYYMMDDHHMMSS.FFFFFF" or "YYYYMMDD HHMMSS.FFFFFF", from a day
/// that is the same for all; nothing for other text.
std::optional<double> moment_of(std::string_view text);

}  // namespace cutaway::reading
