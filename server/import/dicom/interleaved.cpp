#include "import/dicom/interleaved.h"

#include <algorithm>
#include <cmath>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr double kSameThickness = 1.1;  // ratio up to which it is one
constexpr double kEven = 0.1;           // of the median distance

struct Span {
  double lowest = 0.0;
  double highest = 0.0;
};

std::vector<double> heights_of(const DicomGroup& group, glm::dvec3 normal) {
  std::vector<double> heights;
  heights.reserve(group.frames.size());
  for (const auto& frame : group.frames) heights.push_back(glm::dot(frame.position_mm, normal));
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// At least two slices each, and some of one between those of another.
bool are_interleaved(const std::vector<DicomGroup>& parts) {
  if (parts.size() < 2) return false;
  const glm::dvec3 normal = parts.front().frames.front().normal();
  std::vector<Span> spans;
  for (const auto& part : parts) {
    if (part.frames.size() < 2) return false;
    const auto heights = heights_of(part, normal);
    spans.push_back({heights.front(), heights.back()});
  }
  for (std::size_t a = 0; a < spans.size(); ++a) {
    for (std::size_t b = a + 1; b < spans.size(); ++b) {
      const double shared =
          std::min(spans[a].highest, spans[b].highest) - std::max(spans[a].lowest, spans[b].lowest);
      if (shared > 1e-3) return true;
    }
  }
  return false;
}

bool is_even(const DicomGroup& group) {
  const auto heights = heights_of(group, group.frames.front().normal());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights.size(); ++i) gaps.push_back(heights[i] - heights[i - 1]);
  std::sort(gaps.begin(), gaps.end());
  const double median = gaps[gaps.size() / 2];
  return gaps.front() > (1 - kEven) * median && gaps.back() < (1 + kEven) * median;
}

/// Thicknesses that differ by rounding only are one.
std::vector<DicomGroup> by_thickness(const DicomGroup& group) {
  std::vector<double> thicknesses;
  thicknesses.reserve(group.frames.size());
  for (const auto& frame : group.frames) thicknesses.push_back(frame.thickness_mm);
  std::sort(thicknesses.begin(), thicknesses.end());
  std::vector<double> firsts;
  for (const double thickness : thicknesses) {
    if (firsts.empty() || thickness > kSameThickness * firsts.back()) firsts.push_back(thickness);
  }
  FramesByKey by_value;
  for (const auto& frame : group.frames) {
    const auto above = std::upper_bound(firsts.begin(), firsts.end(), frame.thickness_mm);
    by_value[number_in_words(*(above - 1)) + " mm"].push_back(frame);
  }
  return split(group, std::move(by_value), "thickness");
}

std::vector<DicomGroup> by_even_parts(const DicomGroup& group, PlaneKey key) {
  std::vector<DicomGroup> parts = split_by_key(group, key);
  const bool are_apart =
      are_interleaved(parts) && !is_even(group) && std::all_of(parts.begin(), parts.end(), is_even);
  return are_apart ? parts : std::vector{group};
}

}  // namespace

std::vector<DicomGroup> split_interleaved(const DicomGroup& group) {
  std::vector<DicomGroup> parts = by_thickness(group);
  if (are_interleaved(parts)) return parts;
  for (const PlaneKey key :
       {PlaneKey::image_type, PlaneKey::description, PlaneKey::acquisition_number}) {
    parts = by_even_parts(group, key);
    if (parts.size() > 1) return parts;
  }
  return {group};
}

}  // namespace cutaway::reading
