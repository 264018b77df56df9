#include <algorithm>
#include <array>
#include <cmath>

#include "import/data_root.h"
#include "import/grids/byte_stream.h"
#include "import/grids/grid_file.h"
#include "import/grids/nifti_header.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

NiftiHeader read_header(const fs::path& file) {
  std::array<std::byte, 540> bytes{};
  ByteStream input(file, 0, has_gzip_magic(file) ? Compression::deflate : Compression::none);
  return parse_nifti_header(file, std::span(bytes).first(input.read(bytes)));
}

/// "scan.hdr" goes with "scan.img" or "scan.img.gz".
fs::path image_beside(const fs::path& header, const fs::path& root) {
  fs::path stem = header;
  if (lower_case(stem.extension().string()) == ".gz") stem.replace_extension();
  for (const char* ending : {".img", ".img.gz", ".IMG"}) {
    const fs::path image = fs::path(stem).replace_extension(ending);
    std::error_code failed;
    if (fs::exists(fs::symlink_status(image, failed))) {
      return companion_file(header, image.filename().string(), root);
    }
  }
  refuse(header, "the voxels of this header are not there",
         fs::path(stem).replace_extension(".img").filename().string());
}

/// Absent axes of space have one voxel.
std::vector<std::int64_t> extents_of(const NiftiHeader& header) {
  const auto axes = static_cast<std::size_t>(header.dim[0]);
  std::vector<std::int64_t> extents(std::max<std::size_t>(3, axes), 1);
  std::copy_n(header.dim.begin() + 1, axes, extents.begin());
  return extents;
}

void take_rescale(const NiftiHeader& header, GridFile& grid) {
  const bool scaled = std::isfinite(header.slope) && header.slope != 0 &&
                      std::isfinite(header.intercept) && grid.channels == 1;
  if (!scaled) return;
  grid.slope = header.slope;
  grid.intercept = header.intercept;
}

}  // namespace

GridFile open_nifti(const fs::path& file, const fs::path& root, const ImportLimits& limits) {
  const NiftiHeader header = read_header(file);
  const NiftiVoxelType type = nifti_voxel_type(file, header);
  GridFile grid;
  grid.header = file;
  grid.format = "NIfTI";
  grid.channels = type.channels;
  grid.meaning = Channels::colour;
  grid.data.files = {header.single_file ? file : image_beside(file, root)};
  grid.data.encoding = has_gzip_magic(grid.data.files.front()) ? Encoding::deflated : Encoding::raw;
  grid.data.skip_decoded = header.voxel_offset;
  grid.data.component = type.component;
  grid.data.swapped = header.swapped;
  set_extents(grid, extents_of(header), limits);
  const NiftiAffine affine = nifti_affine(file, header);
  grid.steps_mm = affine.steps_mm;
  grid.origin_mm = affine.origin_mm;
  grid.warnings = affine.warnings;
  take_rescale(header, grid);
  return grid;
}

}  // namespace cutaway::reading
