// `cutaway info PATH [--json]`: what a file or folder holds, after reading its voxels.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "import/reader.h"

namespace cutaway {

/// How the command reaches files; both empty in a build without readers, which then knows only
/// phantoms.
struct InfoReaders {
  std::function<Listing(const std::filesystem::path& path, const std::filesystem::path& data_root)>
      scan;
  std::function<Volume(const VolumeSource&)> read;
};

struct InfoRequest {
  std::string path;  ///< a file, a folder, or "phantom:NAME"
  bool as_json = false;
};

/// Prints to `out`: one JSON object {"volumes", "refused"}, or a block of lines a volume. Returns
/// the exit status: 0; 1, with one line on `errors`, where the path does not exist or is a file
/// that holds no readable volume.
int run_info(const InfoRequest& request, const InfoReaders& readers, std::ostream& out,
             std::ostream& errors);

}  // namespace cutaway
