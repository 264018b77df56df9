// Whom and what planes belong to, also where their identifiers are damaged.
#pragma once

#include "import/dicom/group.h"

namespace cutaway::reading {

/// Planes by SeriesInstanceUID, then by patient, study, series number, frame of reference,
/// modality, kernel; localizers for themselves. A plane that leaves one of these open goes with the
/// others where they all agree. An identifier that differs at each slice tells nothing, as those
/// made anew for each file when names were taken out: it is passed over, with a warning.
std::vector<DicomGroup> split_by_identity(std::vector<DicomFrame> frames);

}  // namespace cutaway::reading
