// Volume files and folders: the only door to GDCM and OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/progress.h"
#include "volume/volume.h"

namespace cutaway {

/// Checked from headers, before anything is allocated.
struct ImportLimits {
  std::uint64_t volume_bytes = std::uint64_t{4} << 30;  ///< decoded voxels of one volume
};

/// One volume that a scan found. Only headers were read, so `description.warnings` may grow when it
/// is read.
struct VolumeSource {
  VolumeDescription description;
  VolumeGeometry geometry;                   ///< as far as headers tell
  std::vector<std::filesystem::path> files;  ///< canonical; for a series in no particular order
  std::string part = {};  ///< which of several volumes in the same files; "" where there is one
  std::uint64_t decode_bytes = 0;  ///< that decoding takes beside the voxels themselves
};

struct RefusedFile {
  std::filesystem::path path;
  std::string reason;  ///< one plain sentence: what was expected and what came
};

struct Listing {
  std::vector<VolumeSource> volumes;
  std::vector<RefusedFile> refused;
};

/// A file, or a folder walked to any depth. Files that are no image at all are passed over; those
/// that should have been one and are broken are in `refused`. `data_root` is the folder that no
/// header may lead out of; ids are relative to it. Throws Error only where `path` itself does not
/// exist, Cancelled when stopped. Any thread.
Listing scan_volumes(const std::filesystem::path& path, const std::filesystem::path& data_root,
                     const ImportLimits& limits, std::stop_token stop);

/// Reads and decodes one source's voxels; rescale applied once, geometry in LPS mm. Throws Error
/// with the file's path in `field`, Cancelled when stopped. Any thread; blocks for as long as the
/// file takes.
Volume read_volume(const VolumeSource& source, const ImportLimits& limits,
                   const ProgressSink& progress, std::stop_token stop);

}  // namespace cutaway
