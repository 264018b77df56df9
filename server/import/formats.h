// What the readers of all formats share: their two tasks, and what comes along with each.
#pragma once

#include <span>

#include "import/raw_voxels.h"
#include "import/reader.h"
#include "import/scan_context.h"

namespace cutaway::reading {

struct ReadContext {
  ImportLimits limits;
  ProgressSink progress;
  std::stop_token stop;
};

/// Series and stacks are made of many files (canonical paths): what is broken among them goes to
/// `refused`.
Listing find_dicom(std::span<const std::filesystem::path> files, const ScanContext& context);
Listing find_image_stacks(std::span<const std::filesystem::path> files, const ScanContext& context);

/// Each reads what its namesake found; the files are looked at anew, for they may have changed
/// since. Throws Error.
RawVolume read_dicom(const VolumeSource& source, const ReadContext& context);
RawVolume read_image_stack(const VolumeSource& source, const ReadContext& context);

}  // namespace cutaway::reading
