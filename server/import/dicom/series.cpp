#include "import/dicom/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "import/dicom/copies.h"
#include "import/dicom/identity.h"
#include "import/dicom/interleaved.h"
#include "import/dicom/time_points.h"

namespace cutaway::reading {

namespace {

constexpr double kGeometryTolerance = 1e-3;

bool is_close(glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b) < kGeometryTolerance; }

bool same_pixel_grid(const DicomFrame& a, const DicomFrame& b) {
  return a.image->size_px == b.image->size_px && is_close(a.row_axis, b.row_axis) &&
         is_close(a.column_axis, b.column_axis) &&
         glm::length(a.spacing_mm - b.spacing_mm) < kGeometryTolerance * glm::length(a.spacing_mm);
}

/// The plane's anatomical name, by its normal's largest component.
std::string plane_name(const DicomFrame& frame) {
  const glm::dvec3 normal = glm::abs(frame.normal());
  if (normal.z >= normal.x && normal.z >= normal.y) return "axial";
  return normal.y >= normal.x ? "coronal" : "sagittal";
}

std::vector<DicomGroup> split_by_pixel_grid(const DicomGroup& group) {
  std::vector<std::vector<DicomFrame>> sets;
  for (const auto& frame : group.frames) {
    const auto found = std::find_if(sets.begin(), sets.end(), [&](const auto& set) {
      return same_pixel_grid(set.front(), frame);
    });
    if (found == sets.end()) {
      sets.push_back({frame});
    } else {
      found->push_back(frame);
    }
  }
  if (sets.size() < 2) return {group};
  std::vector<DicomGroup> parts;
  std::map<std::string, int> seen;
  for (auto& set : sets) {
    const std::string plane = plane_name(set.front());
    const int number = ++seen[plane];
    parts.push_back(
        part_of(group, std::move(set), plane, number > 1 ? std::to_string(number) : ""));
  }
  return parts;
}

/// Each of `parts` by what `split` makes of it.
template <typename Split>
std::vector<DicomGroup> each(const std::vector<DicomGroup>& groups, const Split& split) {
  std::vector<DicomGroup> parts;
  for (const auto& group : groups) {
    for (auto& part : split(group)) parts.push_back(std::move(part));
  }
  return parts;
}

/// Those that can part the group into stacks: neither the same everywhere nor other at each plane.
std::vector<PlaneKey> telling_keys(const DicomGroup& group) {
  std::vector<PlaneKey> keys;
  for (std::size_t i = kPlaneKeysThatAlwaysPart; i < kPlaneKeys; ++i) {
    std::set<std::string> values;
    for (const auto& frame : group.frames) values.insert(frame.keys.at(i));
    if (values.size() > 1 && 2 * values.size() <= group.frames.size())
      keys.push_back(static_cast<PlaneKey>(i));
  }
  return keys;
}

/// The first key that leaves no two planes at one place, then the first pair of keys, then the
/// order in time.
std::vector<DicomGroup> split_coinciding(const DicomGroup& group) {
  const std::vector<PlaneKey> keys = telling_keys(group);
  for (const PlaneKey key : keys) {
    std::vector<DicomGroup> parts = split_by_key(group, key);
    if (are_stacks(parts)) return parts;
  }
  for (std::size_t first = 0; first < keys.size(); ++first) {
    for (std::size_t second = first + 1; second < keys.size(); ++second) {
      auto parts = each(split_by_key(group, keys[first]),
                        [&](const DicomGroup& part) { return split_by_key(part, keys[second]); });
      if (are_stacks(parts)) return parts;
    }
  }
  return split_by_moments(group);
}

RefusedFile refuse_coinciding(const DicomGroup& group) {
  return {group.frames.front().image->file,
          fmt::format("several of the {} slices of a series lie at the same place, and nothing in "
                      "their headers parts them into whole stacks",
                      group.frames.size())};
}

/// Numbers that count the slices instead of what they are meant to count tell nothing.
std::vector<DicomGroup> split_unless_scattered(const DicomGroup& group, PlaneKey key) {
  std::vector<DicomGroup> parts = split_by_key(group, key);
  return parts.size() > 2 && parts.size() == group.frames.size() ? std::vector{group} : parts;
}

std::vector<DicomGroup> split_series(const DicomGroup& series) {
  std::vector<DicomGroup> parts = split_by_pixel_grid(series);
  for (std::size_t key = 0; key < kPlaneKeysThatAlwaysPart; ++key) {
    parts = each(parts, [key](const DicomGroup& part) {
      return split_unless_scattered(part, static_cast<PlaneKey>(key));
    });
  }
  return each(parts, split_interleaved);
}

}  // namespace

DicomGrouping group_frames(std::vector<DicomFrame> frames, const std::stop_token& stop) {
  std::sort(frames.begin(), frames.end(), [](const DicomFrame& a, const DicomFrame& b) {
    return std::tie(a.image->file, a.index) < std::tie(b.image->file, b.index);
  });
  DicomGrouping grouping;
  for (auto& part : each(split_by_identity(std::move(frames)), split_series)) {
    sort_along_normal(part.frames);
    if (has_coinciding(part.frames)) leave_out_copies(part, stop);
    if (!has_coinciding(part.frames)) {
      grouping.groups.push_back(std::move(part));
      continue;
    }
    auto parts = split_coinciding(part);
    if (parts.empty()) grouping.refused.push_back(refuse_coinciding(part));
    for (auto& smaller : parts) grouping.groups.push_back(std::move(smaller));
  }
  return grouping;
}

SliceStack stack_of(const DicomGroup& group) {
  const DicomFrame& first = group.frames.front();
  SliceStack stack;
  stack.size_px = first.image->size_px;
  stack.pixel_spacing_mm = first.spacing_mm;
  stack.i_axis = first.row_axis;
  stack.j_axis = first.column_axis;
  stack.position_error_mm = first.position_error_mm;
  stack.axis_error = first.axis_error;
  for (const auto& frame : group.frames) {
    stack.first_pixel_mm.push_back(frame.position_mm);
    // Who writes all digits leaves out zeros at the end.
    stack.position_error_mm = std::min(stack.position_error_mm, frame.position_error_mm);
    stack.axis_error = std::min(stack.axis_error, frame.axis_error);
  }
  return stack;
}

}  // namespace cutaway::reading
