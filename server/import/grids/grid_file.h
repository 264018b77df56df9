// What NIfTI, NRRD and MetaImage come down to: voxels on an affine grid.
#pragma once

#include "import/formats.h"
#include "import/grids/voxel_data.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

struct GridFile {
  std::filesystem::path header;
  std::string format;  ///< as in VolumeDescription
  std::string modality;
  std::string units;         ///< of the values; empty where the file does not say
  VoxelData data;            ///< of everything in the file
  std::size_t channels = 1;  ///< values of a voxel, next to each other
  Channels meaning = Channels::components;
  glm::ivec3 size_voxels{0};
  std::int64_t volumes = 1;  ///< times: the slowest axis
  glm::dmat3 steps_mm{1.0};  ///< columns: from a voxel to the next along i, j, k; LPS
  glm::dvec3 origin_mm{0.0};
  double slope = 1.0;
  double intercept = 0.0;
  std::vector<std::string> warnings;
};

/// Sets `size_voxels`, `volumes` and the data's count from extents as declared (fastest first,
/// without channels), of which the first three are of space. Throws Error for less than three, or
/// for what is beyond the limit.
void set_extents(GridFile& grid, std::span<const std::int64_t> extents, const ImportLimits& limits);

/// What a scan tells of it. Throws Error where the files are too short or the grid cannot be made a
/// right one.
VolumeSource source_of(const GridFile& grid, const ScanContext& context);

/// The first volume's voxels, one value each, on a right grid.
RawVolume read_grid_file(const GridFile& grid, const VolumeSource& source,
                         const ReadContext& context);

/// Parse a header and check it. `root` is canonical: no data file may lie outside. Throw Error
/// naming the file.
GridFile open_nifti(const std::filesystem::path& file, const std::filesystem::path& root,
                    const ImportLimits& limits);
GridFile open_nrrd(const std::filesystem::path& file, const std::filesystem::path& root,
                   const ImportLimits& limits);
GridFile open_metaimage(const std::filesystem::path& file, const std::filesystem::path& root,
                        const ImportLimits& limits);

}  // namespace cutaway::reading
