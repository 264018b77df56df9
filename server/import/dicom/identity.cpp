#include "import/dicom/identity.h"

#include <fmt/format.h>

#include <set>

namespace cutaway::reading {

namespace {

/// Fewer may well be what they say.
constexpr std::size_t kFewestScattered = 3;

std::string_view name_of(Identity which) {
  constexpr std::array<std::string_view, kIdentities> kNames{
      "patient",  "patient", "study", "series", "series", "frame of reference",
      "modality", "role",    "kernel"};
  return kNames.at(static_cast<std::size_t>(which));
}

/// A patient's name and long identifiers are not for a title: a number stands for them.
bool is_shown(Identity which) {
  return which == Identity::series_number || which == Identity::modality ||
         which == Identity::role || which == Identity::kernel;
}

bool may_be_damaged(Identity which) {
  return which == Identity::study || which == Identity::series_number ||
         which == Identity::frame_of_reference;
}

std::size_t count_files(const std::vector<DicomFrame>& frames) {
  std::set<const DicomImage*> images;
  for (const auto& frame : frames) images.insert(frame.image.get());
  return images.size();
}

FramesByKey by_identity(const DicomGroup& group, Identity which) {
  FramesByKey by_value;
  for (const auto& frame : group.frames) by_value[frame.image->of(which)].push_back(frame);
  return by_value;
}

FramesByKey numbered(FramesByKey&& by_value) {
  FramesByKey by_number;
  for (auto& [value, frames] : by_value)
    by_number[std::to_string(by_number.size() + 1)] = std::move(frames);
  return by_number;
}

/// What is left open goes with the only value that there is.
bool is_one(const FramesByKey& by_value) {
  return by_value.size() == 1 || (by_value.size() == 2 && by_value.contains(""));
}

std::vector<DicomGroup> split_by(DicomGroup group, Identity which) {
  FramesByKey by_value = by_identity(group, which);
  const bool is_closed = which == Identity::role;  // a localizer says so, other images do not
  if (!is_closed && is_one(by_value)) return {std::move(group)};
  const std::string name(name_of(which));
  const bool differs_everywhere =
      by_value.size() >= kFewestScattered && by_value.size() == count_files(group.frames);
  if (may_be_damaged(which) && differs_everywhere) {
    // So common among public data that it says nothing of them.
    if (which == Identity::frame_of_reference) return {std::move(group)};
    group.warnings.push_back(fmt::format(
        "each slice names another {}; they were put together by what else they say", name));
    return {std::move(group)};
  }
  return split(group, is_shown(which) ? std::move(by_value) : numbered(std::move(by_value)), name);
}

/// What slices share whose series were made anew for each of them.
std::string shared_identity(const DicomFrame& frame) {
  const DicomImage& image = *frame.image;
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", image.file.parent_path().string(),
                     image.of(Identity::patient_id), image.of(Identity::series_number),
                     image.of(Identity::modality), image.size_px.x, image.size_px.y) +
         frame.key(PlaneKey::description);
}

using SeriesByName = std::map<std::string, DicomGroup>;

/// Series of one slice each that else agree, series number included, were one.
void join_scattered(SeriesByName& series) {
  std::map<std::string, std::vector<std::string>> by_identity;
  for (const auto& [uid, group] : series) {
    const bool is_alone = group.frames.size() == 1 && group.frames.front().image->frames == 1;
    if (is_alone && !group.frames.front().image->of(Identity::series_number).empty())
      by_identity[shared_identity(group.frames.front())].push_back(uid);
  }
  for (const auto& [identity, uids] : by_identity) {
    if (uids.size() < kFewestScattered) continue;
    DicomGroup joined;
    for (const auto& uid : uids)
      joined.frames.push_back(series.extract(uid).mapped().frames.front());
    joined.warnings.emplace_back(
        "each slice names another series; they were put together by what else they say");
    series.emplace(uids.front(), std::move(joined));
  }
}

}  // namespace

std::vector<DicomGroup> split_by_identity(std::vector<DicomFrame> frames) {
  SeriesByName series;
  for (auto& frame : frames)
    series[frame.image->of(Identity::series)].frames.push_back(std::move(frame));
  join_scattered(series);
  std::vector<DicomGroup> groups;
  for (auto& [uid, group] : series) groups.push_back(std::move(group));
  for (std::size_t i = 0; i < kIdentities; ++i) {
    if (static_cast<Identity>(i) == Identity::series) continue;
    std::vector<DicomGroup> finer;
    for (auto& group : groups) {
      for (auto& part : split_by(std::move(group), static_cast<Identity>(i)))
        finer.push_back(std::move(part));
    }
    groups = std::move(finer);
  }
  return groups;
}

}  // namespace cutaway::reading
