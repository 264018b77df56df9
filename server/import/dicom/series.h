// From the planes of many files to volumes: which belong together, in which order.
#pragma once

#include "import/dicom/frame.h"
#include "import/formats.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

/// Planes of one volume, ascending along the normal (row axis x column axis).
struct DicomGroup {
  std::vector<DicomFrame> frames;
  std::string part;  ///< "" where the series is one volume; else what parts it: "echo-2", "coronal"
  std::string label;  ///< the same for people: "echo 2"
  std::vector<std::string> warnings;
};

struct DicomGrouping {
  std::vector<DicomGroup> groups;
  std::vector<RefusedFile> refused;
};

/// By SeriesInstanceUID; within it by size, spacing, orientation, echo, time position and stack;
/// and where planes still lie at the same place, by the first property of the acquisition that
/// parts them into full stacks. Copies of one instance count once, with a warning. Where nothing
/// parts them the planes are refused. The order of `frames` does not matter.
DicomGrouping group_frames(std::vector<DicomFrame> frames);

SliceStack stack_of(const DicomGroup& group);

}  // namespace cutaway::reading
