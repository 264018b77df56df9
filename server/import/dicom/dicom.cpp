#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "import/data_root.h"
#include "import/decode_memory.h"
#include "import/dicom/pixels.h"
#include "import/dicom/series.h"
#include "import/formats.h"
#include "import/refusal.h"
#include "volume/parallel.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// One number type for all planes, and one rescale; else each plane is rescaled as it is read, into
/// floats.
bool is_uniform(const DicomGroup& group) {
  const DicomFrame& first = group.frames.front();
  return std::all_of(group.frames.begin(), group.frames.end(), [&](const DicomFrame& frame) {
    return frame.component == first.component && frame.slope == first.slope &&
           frame.intercept == first.intercept;
  });
}

bool declares_padding(const DicomGroup& group) {
  return std::any_of(group.frames.begin(), group.frames.end(),
                     [](const DicomFrame& frame) { return frame.padding.has_value(); });
}

Component voxel_type(const DicomGroup& group) {
  return is_uniform(group) ? group.frames.front().component : Component::float32;
}

/// All frames of a file are decoded together, also where the volume is made of a few of them.
std::uint64_t decode_bytes(const DicomGroup& group) {
  std::uint64_t bytes = 0;
  for (const auto& frame : group.frames) {
    const auto frame_bytes =
        std::uint64_t(frame.size_px.x) * frame.size_px.y * component_bytes(frame.component);
    bytes = std::max(bytes, frame_bytes * static_cast<std::uint64_t>(frame.frames_in_file));
  }
  return bytes;
}

void require_decodable(const DicomGroup& group, const ImportLimits& limits) {
  const std::uint64_t bytes = decode_bytes(group);
  if (bytes <= limits.volume_bytes) return;
  throw Error({.code = "too-large",
               .message = "the frames of one file are too large together",
               .field = group.frames.front().file.string(),
               .expected = "at most " + bytes_in_words(static_cast<double>(limits.volume_bytes)),
               .received = bytes_in_words(static_cast<double>(bytes))});
}

GridPlan plan_group(const DicomGroup& group, const ImportLimits& limits) {
  const fs::path& file = group.frames.front().file;
  const glm::ivec2 size = group.frames.front().size_px;
  const std::size_t bytes = component_bytes(voxel_type(group));
  checked_voxel_count(
      file,
      std::array{std::int64_t(size.x), std::int64_t(size.y), std::int64_t(group.frames.size())},
      bytes, limits);
  require_decodable(group, limits);
  return plan_grid(file, stack_of(group), bytes, limits);
}

std::vector<fs::path> files_of(const DicomGroup& group) {
  std::set<fs::path> files;
  for (const auto& frame : group.frames) files.insert(frame.file);
  return {files.begin(), files.end()};
}

bool is_hounsfield(const DicomFrame& frame) {
  return frame.modality == "CT" && !frame.is_localizer &&
         (frame.rescale_type.empty() || frame.rescale_type.starts_with("HU"));
}

/// A file of its own goes by its name, a series by its folder.
fs::path place_of(const std::vector<fs::path>& files) {
  return files.size() == 1 ? files.front() : common_folder(files);
}

VolumeDescription describe(const DicomGroup& group, const GridPlan& plan, const fs::path& root) {
  const DicomFrame& first = group.frames.front();
  const fs::path place = place_of(files_of(group));
  VolumeDescription description;
  description.id = volume_id(place, root);
  description.title = first.title.empty() ? printable(place.filename().string()) : first.title;
  if (!group.label.empty()) description.title += " (" + group.label + ")";
  description.format = "DICOM";
  description.modality = first.modality;
  description.units = is_hounsfield(first) ? "HU" : "none";
  description.window = first.window;
  description.warnings = group.warnings;
  description.warnings.insert(description.warnings.end(), plan.warnings.begin(),
                              plan.warnings.end());
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
  DicomGrouping grouping = group_frames(std::move(frames));
  for (auto& group : grouping.groups) {
    if (grouping.groups.size() == 1 || group.part == source.part) return std::move(group);
  }
  refuse(source.files.front(), "the series changed while it was read");
}

/// Which slices of the volume each file holds.
std::vector<std::vector<std::size_t>> slices_by_file(const DicomGroup& group) {
  std::map<fs::path, std::vector<std::size_t>> by_file;
  for (std::size_t k = 0; k < group.frames.size(); ++k) by_file[group.frames[k].file].push_back(k);
  std::vector<std::vector<std::size_t>> slices;
  slices.reserve(by_file.size());
  for (auto& [file, of_file] : by_file) slices.push_back(std::move(of_file));
  return slices;
}

struct Decoded {
  RawVoxels voxels;
  PaddingMask padding;
};

Decoded decode(const DicomGroup& group, const ReadContext& context) {
  const glm::ivec2 size = group.frames.front().size_px;
  const std::size_t slice_voxels = std::size_t(size.x) * size.y;
  Decoded decoded{make_raw_voxels(voxel_type(group), slice_voxels * group.frames.size()), {}};
  if (declares_padding(group)) decoded.padding.resize(count_of(decoded.voxels));
  const auto by_file = slices_by_file(group);
  const auto decode_file = [&](int i) {
    const auto& slices = by_file[static_cast<std::size_t>(i)];
    const DicomFrame& any = group.frames[slices.front()];
    const DicomPixels pixels(any, static_cast<std::size_t>(any.frames_in_file));
    for (const std::size_t k : slices)
      pixels.store(group.frames[k], k * slice_voxels, decoded.voxels, decoded.padding);
  };
  const auto report = [&](double fraction) {
    if (context.progress) context.progress(LoadStage::decode, fraction);
  };
  run_parallel({.count = static_cast<int>(by_file.size()),
                .turn = decode_file,
                .progress = report,
                .threads = decode_threads(decode_bytes(group))},
               context.stop);
  return decoded;
}

}  // namespace

Listing find_dicom(std::span<const fs::path> files, const ScanContext& context) {
  Listing listing;
  std::vector<DicomFrame> frames = read_headers(files, context, listing.refused);
  if (context.on_grouping) context.on_grouping();
  DicomGrouping grouping = group_frames(std::move(frames));
  std::vector<Found> found;
  for (const auto& group : grouping.groups) {
    try {
      const GridPlan plan = plan_group(group, context.limits);
      found.push_back({{describe(group, plan, context.root), plan.geometry, files_of(group),
                        group.part, decode_bytes(group)},
                       group.frames.front().series_uid});
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
  if (is_uniform(group)) {
    raw.slope = group.frames.front().slope;
    raw.intercept = group.frames.front().intercept;
  }
  Decoded decoded = decode(group, context);
  raw.voxels = std::move(decoded.voxels);
  const std::size_t padded =
      replace_padding(source.files.front(), decoded.padding, raw.slope, raw.voxels);
  if (padded > 0) {
    raw.description.warnings.push_back(fmt::format(
        "{} pixels are padding outside of the image; each was set to the smallest value", padded));
  }
  if (plan.needs_resampling)
    raw.voxels = resample(raw.voxels, stack_of(group), plan, raw.slope, context.stop);
  return raw;
}

}  // namespace cutaway::reading
