// From the planes of many files to volumes: which belong together, in which order.
#pragma once

#include "import/dicom/group.h"
#include "import/formats.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

struct DicomGrouping {
  std::vector<DicomGroup> groups;
  std::vector<RefusedFile> refused;
};

/// By identity (identity.h), size, spacing, orientation, echo, time position and stack; where
/// stacks of other thickness or kind lie between each other, by that; and where planes still lie at
/// the same place, after copies are left out, by the first property of the acquisition that parts
/// them into full stacks, or by the order in which they were taken. Where nothing parts them the
/// planes are refused. The order of `frames` does not matter. Reads pixels only of planes that lie
/// at the same place.
DicomGrouping group_frames(std::vector<DicomFrame> frames, const std::stop_token& stop);

SliceStack stack_of(const DicomGroup& group);

}  // namespace cutaway::reading
