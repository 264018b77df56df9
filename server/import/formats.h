// What the readers of all formats share: their two tasks, and what comes along with each.
#pragma once

#include <functional>
#include <set>
#include <span>

#include "import/raw_voxels.h"
#include "import/reader.h"

namespace cutaway::reading {

struct ScanContext {
  std::filesystem::path root;  ///< canonical
  ImportLimits limits;
  std::stop_token stop;
  std::set<std::filesystem::path> skip;                            ///< not even to be opened
  std::function<void(const std::filesystem::path& file)> on_file;  ///< before each is opened
  std::function<void()> on_grouping;  ///< when all DICOM headers are read and no file is at work

  /// Throws Cancelled when stopped.
  void begin_file(const std::filesystem::path& file) const {
    throw_if_cancelled(stop);
    if (on_file) on_file(file);
  }
};

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
