#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/released_pages.h"
#include "import/data_root.h"
#include "import/decode_memory.h"
#include "import/dicom/pixels.h"
#include "import/dicom/series.h"
#include "import/dicom/transfer_syntax.h"
#include "import/dicom/window.h"
#include "import/formats.h"
#include "import/refusal.h"
#include "volume/parallel.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// One number type for all planes, and one meaning of their values; else each plane is rescaled as
/// it is read, into floats.
bool is_uniform(const DicomGroup& group) {
  const DicomFrame& first = group.frames.front();
  return std::all_of(group.frames.begin(), group.frames.end(), [&](const DicomFrame& frame) {
    return frame.image->component == first.image->component && frame.meaning == first.meaning;
  });
}

bool declares_padding(const DicomGroup& group) {
  return std::any_of(group.frames.begin(), group.frames.end(),
                     [](const DicomFrame& frame) { return frame.image->padding.has_value(); });
}

/// A table gives 16 bits whatever it is given.
Component voxel_type(const DicomGroup& group) {
  if (!is_uniform(group)) return Component::float32;
  const DicomFrame& first = group.frames.front();
  return first.meaning.table ? Component::uint16 : first.image->component;
}

std::uint64_t frame_bytes(const DicomGroup& group) {
  const DicomImage& image = *group.frames.front().image;
  return std::uint64_t(image.size_px.x) * image.size_px.y * component_bytes(image.component);
}

GridPlan plan_group(const DicomGroup& group, const ImportLimits& limits) {
  const DicomImage& image = *group.frames.front().image;
  if (image.is_localizer() && group.frames.size() < 2)
    refuse(image.file, "this is a localizer, a view to plan the other series by, and no volume");
  const std::size_t bytes = component_bytes(voxel_type(group));
  checked_voxel_count(image.file,
                      std::array{std::int64_t(image.size_px.x), std::int64_t(image.size_px.y),
                                 std::int64_t(group.frames.size())},
                      bytes, limits);
  return plan_grid(image.file, stack_of(group), bytes, limits);
}

std::vector<fs::path> files_of(const DicomGroup& group) {
  std::set<fs::path> files;
  for (const auto& frame : group.frames) files.insert(frame.image->file);
  return {files.begin(), files.end()};
}

/// Where slices measure different things there is no one unit.
std::string units_of(const DicomGroup& group) {
  const std::string& units = group.frames.front().meaning.units;
  const bool are_same =
      std::all_of(group.frames.begin(), group.frames.end(),
                  [&](const DicomFrame& frame) { return frame.meaning.units == units; });
  return are_same ? units : "none";
}

bool is_ct_without_rescale(const DicomGroup& group) {
  const DicomFrame& first = group.frames.front();
  return first.image->of(Identity::modality) == "CT" && !first.image->is_localizer() &&
         !first.meaning.is_stated;
}

/// A file of its own goes by its name, a series by its folder.
fs::path place_of(const std::vector<fs::path>& files) {
  return files.size() == 1 ? files.front() : common_folder(files);
}

VolumeDescription describe(const DicomGroup& group, const GridPlan& plan, const fs::path& root) {
  const DicomImage& first = *group.frames.front().image;
  const fs::path place = place_of(files_of(group));
  VolumeDescription description;
  description.id = volume_id(place, root);
  description.title = first.title.empty() ? printable(place.filename().string()) : first.title;
  if (!group.label.empty()) description.title += " (" + group.label + ")";
  description.format = "DICOM";
  description.modality = first.of(Identity::modality);
  description.units = units_of(group);
  description.window = window_of_middle(group);
  description.warnings = group.warnings;
  description.warnings.insert(description.warnings.end(), plan.warnings.begin(),
                              plan.warnings.end());
  if (is_ct_without_rescale(group)) {
    description.warnings.emplace_back(
        "the file gives no rescale, so that its values need not be Hounsfield units");
  }
  if (first.low_is_bright) {
    description.warnings.emplace_back("the images are meant to be shown inverted (MONOCHROME1)");
  }
  return description;
}

struct Found {
  VolumeSource source;
  std::string series_uid;
};

/// Two volumes of one folder need more than its name to tell them apart.
void make_ids_unique(std::vector<Found>& found) {
  std::map<std::string, int> uses;
  for (const auto& [source, uid] : found) ++uses[source.description.id];
  for (auto& [source, uid] : found) {
    std::string& id = source.description.id;
    if (uses[id] < 2) continue;
    id += "~" + short_hash(uid);
    if (!source.part.empty()) id += "~" + source.part;
  }
}

std::vector<DicomFrame> read_headers(std::span<const fs::path> files, const ScanContext& context,
                                     std::vector<RefusedFile>& refused) {
  std::vector<DicomFrame> frames;
  for (const auto& file : files) {
    try {
      auto found = context.look_into(file, [&file] { return read_dicom_frames(file); });
      std::move(found.begin(), found.end(), std::back_inserter(frames));
    } catch (const Error& error) {
      refused.push_back({file, reason_of(error)});
    }
  }
  return frames;
}

/// The group that a scan described; its files alone may group to itself, or, where several volumes
/// share a file, to all of them.
DicomGroup group_of(const VolumeSource& source, const ReadContext& context) {
  std::vector<DicomFrame> frames;
  for (std::size_t i = 0; i < source.files.size(); ++i) {
    throw_if_cancelled(context.stop);
    for (auto& frame : read_dicom_frames(source.files[i])) frames.push_back(std::move(frame));
    const auto read = static_cast<double>(i + 1) / static_cast<double>(source.files.size());
    if (context.progress) context.progress(LoadStage::read, read);
  }
  DicomGrouping grouping = group_frames(std::move(frames), context.stop);
  for (auto& group : grouping.groups) {
    if (grouping.groups.size() == 1 || group.part == source.part) return std::move(group);
  }
  refuse(source.files.front(), "the series changed while it was read");
}

/// What one turn decodes: slices of the volume that lie in one file; not all of a file of many,
/// unless it is unpacked as a whole.
std::vector<std::vector<std::size_t>> turns_of(const DicomGroup& group) {
  constexpr std::size_t kMostSlices = 32;
  std::map<fs::path, std::vector<std::size_t>> by_file;
  for (std::size_t k = 0; k < group.frames.size(); ++k)
    by_file[group.frames[k].image->file].push_back(k);
  std::vector<std::vector<std::size_t>> turns;
  for (const auto& [file, slices] : by_file) {
    const bool is_whole =
        is_unpacked_as_a_whole(group.frames[slices.front()].image->transfer_syntax);
    for (std::size_t i = 0; i < slices.size(); ++i) {
      if (i == 0 || (i % kMostSlices == 0 && !is_whole)) turns.emplace_back();
      turns.back().push_back(slices[i]);
    }
  }
  return turns;
}

/// Frames are decoded beside each other in a third of what the volume itself takes, and a little.
int threads_for(const DicomGroup& group) {
  constexpr std::uint64_t kLittleBytes = std::uint64_t{24} << 20;
  constexpr std::uint64_t kFrameCopies = 4;  // packed, in the codec, as its picture, as bytes
  const std::uint64_t frame = std::max<std::uint64_t>(frame_bytes(group), 1);
  const std::uint64_t room = kLittleBytes + frame * group.frames.size() / 3;
  const std::uint64_t fit = std::max<std::uint64_t>(room / (kFrameCopies * frame), 1);
  return static_cast<int>(std::min<std::uint64_t>(decode_threads(frame), fit));
}

struct Decoded {
  RawVoxels voxels;
  PaddingMask padding;
};

/// A file that is unpacked as a whole goes away as its frames, in its order, become voxels.
void decode_turn(const DicomGroup& group, std::vector<std::size_t> slices, Decoded& decoded) {
  const DicomImage& image = *group.frames[slices.front()].image;
  const std::size_t slice_voxels = std::size_t(image.size_px.x) * image.size_px.y;
  std::ranges::sort(slices, {}, [&](std::size_t k) { return group.frames[k].index; });
  PixelFile pixels(group.frames[slices.front()].image);
  for (const std::size_t k : slices) {
    store_frame(pixels, group.frames[k], k * slice_voxels, decoded.voxels, decoded.padding);
    pixels.forget(group.frames[k].index);
  }
}

Decoded decode(const DicomGroup& group, const ReadContext& context) {
  const glm::ivec2 size = group.frames.front().image->size_px;
  const std::size_t slice_voxels = std::size_t(size.x) * size.y;
  Decoded decoded{make_raw_voxels(voxel_type(group), slice_voxels * group.frames.size()), {}};
  release_pages(bytes_of(decoded.voxels));  // zeros that take no memory until they are written over
  if (declares_padding(group)) decoded.padding = PaddingMask(count_of(decoded.voxels));
  const auto turns = turns_of(group);
  const auto report = [&](double fraction) {
    if (context.progress) context.progress(LoadStage::decode, fraction);
  };
  run_parallel(
      {.count = static_cast<int>(turns.size()),
       .turn = [&](int i) { decode_turn(group, turns[static_cast<std::size_t>(i)], decoded); },
       .progress = report,
       .threads = threads_for(group)},
      context.stop);
  return decoded;
}

}  // namespace

Listing find_dicom(std::span<const fs::path> files, const ScanContext& context) {
  Listing listing;
  std::vector<DicomFrame> frames = read_headers(files, context, listing.refused);
  if (context.on_grouping) context.on_grouping();
  DicomGrouping grouping = group_frames(std::move(frames), context.stop);
  std::vector<Found> found;
  for (const auto& group : grouping.groups) {
    try {
      const GridPlan plan = plan_group(group, context.limits);
      found.push_back({{describe(group, plan, context.root), plan.geometry, files_of(group),
                        group.part, frame_bytes(group)},
                       group.frames.front().image->of(Identity::series)});
    } catch (const Error& error) {
      listing.refused.push_back({place_of(files_of(group)), reason_of(error)});
    }
  }
  make_ids_unique(found);
  for (auto& [source, uid] : found) listing.volumes.push_back(std::move(source));
  listing.refused.insert(listing.refused.end(), grouping.refused.begin(), grouping.refused.end());
  return listing;
}

RawVolume read_dicom(const VolumeSource& source, const ReadContext& context) {
  const DicomGroup group = group_of(source, context);
  const GridPlan plan = plan_group(group, context.limits);
  RawVolume raw;
  raw.description = source.description;
  raw.geometry = plan.geometry;
  const ValueMeaning& meaning = group.frames.front().meaning;
  if (is_uniform(group) && !meaning.table) {
    raw.slope = meaning.slope;
    raw.intercept = meaning.intercept;
  }
  Decoded decoded = decode(group, context);
  raw.voxels = std::move(decoded.voxels);
  const std::size_t padded =
      replace_padding(source.files.front(), decoded.padding, raw.slope, raw.voxels);
  if (padded > 0) {
    raw.description.warnings.push_back(fmt::format(
        "{} pixels are padding outside of the image; each was set to the smallest value", padded));
  }
  leave_out_useless_window(raw);
  if (plan.needs_resampling) {
    const PaddingMask* padding = decoded.padding.empty() ? nullptr : &decoded.padding;
    raw.voxels = resample(std::move(raw.voxels), stack_of(group), plan,
                          {raw.slope, raw.intercept, padding}, context.stop);
  }
  return raw;
}

}  // namespace cutaway::reading
