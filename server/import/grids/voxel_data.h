// How a file's voxels are written down, and reading them.
#pragma once

#include <filesystem>
#include <vector>

#include "import/formats.h"
#include "import/raw_voxels.h"

namespace cutaway::reading {

enum class Encoding { raw, deflated, bzip2, ascii, hex };

struct VoxelData {
  std::vector<std::filesystem::path> files;  ///< each holds an equal share, in order
  Encoding encoding = Encoding::raw;
  std::uint64_t begin = 0;         ///< in each file, where the encoded data begin
  bool at_end_of_file = false;     ///< raw only: the data are the last bytes instead
  std::uint64_t skip_decoded = 0;  ///< bytes to pass over once decompressed
  Component component = Component::uint8;
  bool swapped = false;     ///< the file's byte order is not ours
  std::uint64_t count = 0;  ///< elements in all files
};

/// True where the bytes of a file in that order have to be reversed on this machine.
bool is_swapped(bool file_is_big_endian);

/// Compares the files' sizes with the least that the header's promise takes, before anything is
/// allocated. Throws Error naming the file.
void require_file_sizes(const VoxelData& data);

/// The first `count` elements. Reports LoadStage::read; looks at the stop token between pieces.
/// Throws Error naming the file where it ends before or is broken.
RawVoxels read_voxel_data(const VoxelData& data, std::uint64_t count, const ReadContext& context);

}  // namespace cutaway::reading
