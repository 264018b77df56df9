#include "import/dicom/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "import/data_root.h"
#include "import/natural_order.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr double kAxisTolerance = 1e-3;
constexpr double kSamePlaceMm = 1e-3;

glm::dvec3 normal_of(const DicomFrame& frame) {
  return glm::cross(frame.row_axis, frame.column_axis);
}

bool is_close(glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b) < kAxisTolerance; }

bool same_pixel_grid(const DicomFrame& a, const DicomFrame& b) {
  return a.size_px == b.size_px && is_close(a.row_axis, b.row_axis) &&
         is_close(a.column_axis, b.column_axis) &&
         glm::length(a.spacing_mm - b.spacing_mm) < kAxisTolerance * glm::length(a.spacing_mm);
}

/// The plane's anatomical name, by its normal's largest component.
std::string plane_name(const DicomFrame& frame) {
  const glm::dvec3 normal = glm::abs(normal_of(frame));
  if (normal.z >= normal.x && normal.z >= normal.y) return "axial";
  return normal.y >= normal.x ? "coronal" : "sagittal";
}

void sort_along_normal(std::vector<DicomFrame>& frames) {
  const glm::dvec3 normal = normal_of(frames.front());
  std::sort(frames.begin(), frames.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    const double height_a = glm::dot(a.position_mm, normal);
    const double height_b = glm::dot(b.position_mm, normal);
    return std::tie(height_a, a.file, a.index) < std::tie(height_b, b.file, b.index);
  });
}

/// For frames sorted along their normal.
bool has_coinciding(const std::vector<DicomFrame>& frames) {
  const glm::dvec3 normal = normal_of(frames.front());
  return std::adjacent_find(frames.begin(), frames.end(), [&](const auto& a, const auto& b) {
           return glm::dot(b.position_mm - a.position_mm, normal) < kSamePlaceMm;
         }) != frames.end();
}

DicomGroup part_of(const DicomGroup& whole, std::vector<DicomFrame> frames, const std::string& name,
                   const std::string& value) {
  DicomGroup part{.frames = std::move(frames),
                  .part = whole.part,
                  .label = whole.label,
                  .warnings = whole.warnings};
  std::string word = lower_case(name + (value.empty() ? "" : "-" + value));
  const auto unsafe = [](char c) {
    return !(std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-');
  };
  std::replace_if(word.begin(), word.end(), unsafe, '-');
  if (word.size() > 32) word = lower_case(name) + "-" + short_hash(value);
  std::replace(word.begin(), word.end(), ' ', '-');
  part.part += (part.part.empty() ? "" : "~") + word;
  part.label += (part.label.empty() ? "" : ", ") + name + (value.empty() ? "" : " " + value);
  return part;
}

/// Parts a group by the value of one key; one group again where all agree.
std::vector<DicomGroup> split_by_key(const DicomGroup& group, PlaneKey key) {
  std::map<std::string, std::vector<DicomFrame>, NaturalOrder> by_value;
  for (const auto& frame : group.frames) {
    by_value[frame.keys.at(static_cast<std::size_t>(key))].push_back(frame);
  }
  if (by_value.size() < 2) return {group};
  std::vector<DicomGroup> parts;
  parts.reserve(by_value.size());
  for (auto& [value, frames] : by_value) {
    parts.push_back(part_of(group, std::move(frames), std::string(name_of(key)),
                            value.empty() ? "none" : value));
  }
  return parts;
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

bool are_stacks(std::vector<DicomGroup>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](DicomGroup& part) {
    sort_along_normal(part.frames);
    return part.frames.size() > 1 && !has_coinciding(part.frames);
  });
}

/// The first key that leaves no two planes at one place, then the first pair of keys.
std::vector<DicomGroup> split_coinciding(const DicomGroup& group) {
  for (std::size_t key = kPlaneKeysThatAlwaysPart; key < kPlaneKeys; ++key) {
    std::vector<DicomGroup> parts = split_by_key(group, static_cast<PlaneKey>(key));
    if (are_stacks(parts)) return parts;
  }
  for (std::size_t first = kPlaneKeysThatAlwaysPart; first < kPlaneKeys; ++first) {
    for (std::size_t second = first + 1; second < kPlaneKeys; ++second) {
      std::vector<DicomGroup> parts;
      for (const auto& part : split_by_key(group, static_cast<PlaneKey>(first))) {
        for (auto& smaller : split_by_key(part, static_cast<PlaneKey>(second))) {
          parts.push_back(std::move(smaller));
        }
      }
      if (are_stacks(parts)) return parts;
    }
  }
  return {};
}

RefusedFile refuse_coinciding(const DicomGroup& group) {
  return {group.frames.front().file,
          fmt::format("several of the {} slices of a series lie at the same place, and nothing in "
                      "their headers tells them apart",
                      group.frames.size())};
}

/// The same instance may lie in the folder twice.
void drop_copies(DicomGroup& series) {
  std::set<std::pair<std::string, int>> seen;
  const std::size_t before = series.frames.size();
  std::erase_if(series.frames, [&](const DicomFrame& frame) {
    return !frame.instance_uid.empty() && !seen.emplace(frame.instance_uid, frame.index).second;
  });
  const std::size_t copies = before - series.frames.size();
  if (copies > 0)
    series.warnings.push_back(fmt::format("{} slices are copies of others; left out", copies));
}

std::vector<DicomGroup> split_series(const DicomGroup& series) {
  std::vector<DicomGroup> parts = split_by_pixel_grid(series);
  for (std::size_t key = 0; key < kPlaneKeysThatAlwaysPart; ++key) {
    std::vector<DicomGroup> finer;
    for (const auto& part : parts) {
      for (auto& smaller : split_by_key(part, static_cast<PlaneKey>(key)))
        finer.push_back(std::move(smaller));
    }
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace

DicomGrouping group_frames(std::vector<DicomFrame> frames) {
  std::sort(frames.begin(), frames.end(), [](const DicomFrame& a, const DicomFrame& b) {
    return std::tie(a.file, a.index) < std::tie(b.file, b.index);
  });
  std::map<std::string, DicomGroup> series;
  for (auto& frame : frames) series[frame.series_uid].frames.push_back(std::move(frame));
  DicomGrouping grouping;
  for (auto& [uid, whole] : series) {
    drop_copies(whole);
    for (auto& part : split_series(whole)) {
      sort_along_normal(part.frames);
      if (part.frames.size() < 2 || !has_coinciding(part.frames)) {
        grouping.groups.push_back(std::move(part));
        continue;
      }
      auto parts = split_coinciding(part);
      if (parts.empty()) grouping.refused.push_back(refuse_coinciding(part));
      for (auto& smaller : parts) grouping.groups.push_back(std::move(smaller));
    }
  }
  return grouping;
}

SliceStack stack_of(const DicomGroup& group) {
  const DicomFrame& first = group.frames.front();
  SliceStack stack;
  stack.size_px = first.size_px;
  stack.pixel_spacing_mm = first.spacing_mm;
  stack.i_axis = first.row_axis;
  stack.j_axis = first.column_axis;
  for (const auto& frame : group.frames) stack.first_pixel_mm.push_back(frame.position_mm);
  return stack;
}

}  // namespace cutaway::reading
