#include "import/dicom/group.h"

#include <algorithm>
#include <tuple>

#include "import/data_root.h"
#include "import/natural_order.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

constexpr double kSamePlaceMm = 1e-3;

/// Safe in an address, and short.
std::string word_of(const std::string& name, const std::string& value) {
  std::string word = lower_case(name + (value.empty() ? "" : "-" + value));
  const auto is_unsafe = [](char c) {
    return !(std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-');
  };
  std::replace_if(word.begin(), word.end(), is_unsafe, '-');
  if (word.size() > 32) word = lower_case(name) + "-" + short_hash(value);
  std::replace(word.begin(), word.end(), ' ', '-');
  return word;
}

}  // namespace

bool KeyOrder::operator()(const std::string& a, const std::string& b) const {
  const auto number_a = real_of(a);
  const auto number_b = real_of(b);
  if (number_a && number_b && *number_a != *number_b) return *number_a < *number_b;
  if (number_a.has_value() != number_b.has_value()) return number_b.has_value();
  return NaturalOrder()(a, b);
}

DicomGroup part_of(const DicomGroup& whole, std::vector<DicomFrame> frames, const std::string& name,
                   const std::string& value) {
  DicomGroup part{.frames = std::move(frames),
                  .part = whole.part,
                  .label = whole.label,
                  .warnings = whole.warnings};
  part.part += (part.part.empty() ? "" : "~") + word_of(name, value);
  part.label += (part.label.empty() ? "" : ", ") + name + (value.empty() ? "" : " " + value);
  return part;
}

std::vector<DicomGroup> split(const DicomGroup& whole, FramesByKey&& by_key,
                              const std::string& name) {
  if (by_key.size() < 2) return {whole};
  std::vector<DicomGroup> parts;
  parts.reserve(by_key.size());
  for (auto& [value, frames] : by_key)
    parts.push_back(part_of(whole, std::move(frames), name, value.empty() ? "none" : value));
  return parts;
}

std::vector<DicomGroup> split_by_key(const DicomGroup& whole, PlaneKey key) {
  FramesByKey by_value;
  for (const auto& frame : whole.frames) by_value[frame.key(key)].push_back(frame);
  return split(whole, std::move(by_value), std::string(name_of(key)));
}

void sort_along_normal(std::vector<DicomFrame>& frames) {
  const glm::dvec3 normal = frames.front().normal();
  std::sort(frames.begin(), frames.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    const double height_a = glm::dot(a.position_mm, normal);
    const double height_b = glm::dot(b.position_mm, normal);
    return std::tie(height_a, a.image->file, a.index) < std::tie(height_b, b.image->file, b.index);
  });
}

std::vector<std::size_t> places_of(const std::vector<DicomFrame>& frames) {
  const glm::dvec3 normal = frames.front().normal();
  std::vector<std::size_t> places{0};
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double step = glm::dot(frames[i].position_mm - frames[i - 1].position_mm, normal);
    places.push_back(places.back() + (step < kSamePlaceMm ? 0 : 1));
  }
  return places;
}

bool has_coinciding(const std::vector<DicomFrame>& frames) {
  return places_of(frames).back() + 1 < frames.size();
}

bool are_stacks(std::vector<DicomGroup>& groups) {
  return std::all_of(groups.begin(), groups.end(), [](DicomGroup& group) {
    if (group.frames.size() < 2) return false;
    sort_along_normal(group.frames);
    return !has_coinciding(group.frames);
  });
}

}  // namespace cutaway::reading
