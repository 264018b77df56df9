#include "import/grids/grid_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/data_root.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kMostVolumes = 1'000'000;

std::size_t voxel_bytes(const GridFile& grid) {
  return component_bytes(grid.data.component) * grid.channels;
}

std::uint64_t values_of_a_volume(const GridFile& grid) {
  return std::uint64_t(grid.size_voxels.x) * grid.size_voxels.y * grid.size_voxels.z *
         grid.channels;
}

struct LaidOut {
  SliceStack stack;
  GridPlan plan;
  std::vector<std::string> warnings;
};

std::string channels_warning(const GridFile& grid) {
  if (grid.meaning == Channels::colour && grid.channels >= 3)
    return "colour was reduced to its luminance";
  return fmt::format("each voxel has {} values; the first is shown", grid.channels);
}

LaidOut lay_out(const GridFile& grid, const ImportLimits& limits) {
  LaidOut result;
  result.stack = stack_of_affine(grid.size_voxels, grid.steps_mm, grid.origin_mm);
  result.plan = plan_grid(grid.header, result.stack, voxel_bytes(grid), limits);
  result.warnings = grid.warnings;
  result.warnings.insert(result.warnings.end(), result.plan.warnings.begin(),
                         result.plan.warnings.end());
  if (grid.volumes > 1) {
    result.warnings.push_back(fmt::format(
        "the file holds {} volumes (times or components); the first is shown", grid.volumes));
  }
  if (grid.channels > 1) result.warnings.push_back(channels_warning(grid));
  return result;
}

std::string units_of(const GridFile& grid) {
  if (!grid.units.empty()) return grid.units;
  return grid.modality == "CT" ? "HU" : "none";
}

std::string title_of(const fs::path& file) {
  fs::path stem = file.stem();
  if (lower_case(file.extension().string()) == ".gz") stem = stem.stem();
  return printable(stem.string());
}

}  // namespace

void set_extents(GridFile& grid, std::span<const std::int64_t> extents,
                 const ImportLimits& limits) {
  if (extents.size() < 3) {
    refuse(grid.header, "a single slice is no volume", "3 axes of space",
           std::to_string(extents.size()));
  }
  checked_voxel_count(grid.header, extents.first(3), voxel_bytes(grid), limits);
  grid.size_voxels = {extents[0], extents[1], extents[2]};
  grid.volumes = 1;
  for (const std::int64_t extent : extents.subspan(3)) {
    if (extent < 1 || extent > kMostVolumes / grid.volumes) {
      refuse(grid.header, "an extent is not usable", "1 or more along each axis",
             std::to_string(extent));
    }
    grid.volumes *= extent;
  }
  grid.data.count = values_of_a_volume(grid) * static_cast<std::uint64_t>(grid.volumes);
}

VolumeSource source_of(const GridFile& grid, const ScanContext& context) {
  require_file_sizes(grid.data);
  const LaidOut laid_out = lay_out(grid, context.limits);
  VolumeSource source;
  source.description = {.id = volume_id(grid.header, context.root),
                        .title = title_of(grid.header),
                        .format = grid.format,
                        .modality = grid.modality,
                        .units = units_of(grid),
                        .warnings = laid_out.warnings};
  source.geometry = laid_out.plan.geometry;
  source.files = {grid.header};
  for (const auto& file : grid.data.files) {
    if (file != grid.header) source.files.push_back(file);
  }
  return source;
}

RawVolume read_grid_file(const GridFile& grid, const VolumeSource& source,
                         const ReadContext& context) {
  require_file_sizes(grid.data);
  const LaidOut laid_out = lay_out(grid, context.limits);
  RawVolume raw;
  raw.description = source.description;
  raw.description.warnings = laid_out.warnings;
  raw.geometry = laid_out.plan.geometry;
  raw.voxels = read_voxel_data(grid.data, values_of_a_volume(grid), context);
  if (grid.channels > 1) reduce_channels(raw.voxels, grid.channels, grid.meaning);
  if (laid_out.plan.needs_resampling) {
    raw.voxels = resample(std::move(raw.voxels), laid_out.stack, laid_out.plan,
                          {.slope = grid.slope, .intercept = grid.intercept}, context.stop);
  }
  raw.slope = grid.slope;
  raw.intercept = grid.intercept;
  return raw;
}

}  // namespace cutaway::reading
