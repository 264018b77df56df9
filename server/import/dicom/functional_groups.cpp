#include "import/dicom/functional_groups.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/dicom/dataset.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// A macro of a frame: in its own groups, else in the shared ones.
class FrameGroups {
 public:
  FrameGroups(const gdcm::DataSet& shared, const gdcm::DataSet& own) : shared_(shared), own_(own) {}

  std::optional<gdcm::DataSet> macro(std::uint16_t group, std::uint16_t element) const {
    if (auto item = first_item_at(own_, group, element)) return item;
    return first_item_at(shared_, group, element);
  }

  std::vector<double> decimals(std::uint16_t group, std::uint16_t element,
                               std::uint16_t value_group, std::uint16_t value_element) const {
    const auto item = macro(group, element);
    return item ? decimals_at(*item, value_group, value_element) : std::vector<double>();
  }

  std::string binary_text(std::uint16_t group, std::uint16_t element, std::uint16_t value_group,
                          std::uint16_t value_element) const {
    const auto item = macro(group, element);
    const auto value = item ? binary_at(*item, value_group, value_element) : std::nullopt;
    return value ? number_in_words(*value) : std::string();
  }

  std::string text(std::uint16_t group, std::uint16_t element, std::uint16_t value_group,
                   std::uint16_t value_element) const {
    const auto item = macro(group, element);
    return item ? text_at(*item, value_group, value_element) : std::string();
  }

 private:
  const gdcm::DataSet& shared_;
  const gdcm::DataSet& own_;
};

void require_count(const DicomFrame& frame, const std::vector<double>& numbers, std::size_t count,
                   const char* name) {
  if (are_finite(numbers, count)) return;
  refuse(frame.file, fmt::format("frame {} has no usable {}", frame.index + 1, name),
         fmt::format("{} finite numbers", count), fmt::format("{}", fmt::join(numbers, ", ")));
}

void place_frame(DicomFrame& frame, const FrameGroups& groups) {
  const auto position = groups.decimals(0x0020, 0x9113, 0x0020, 0x0032);
  const auto axes = groups.decimals(0x0020, 0x9116, 0x0020, 0x0037);
  const auto spacing = groups.decimals(0x0028, 0x9110, 0x0028, 0x0030);
  require_count(frame, position, 3, "ImagePositionPatient");
  require_count(frame, axes, 6, "ImageOrientationPatient");
  require_count(frame, spacing, 2, "PixelSpacing");
  frame.position_mm = {position[0], position[1], position[2]};
  frame.row_axis = {axes[0], axes[1], axes[2]};
  frame.column_axis = {axes[3], axes[4], axes[5]};
  frame.spacing_mm = {spacing[1], spacing[0]};
}

void rescale_frame(DicomFrame& frame, const FrameGroups& groups) {
  const auto slope = groups.decimals(0x0028, 0x9145, 0x0028, 0x1053);
  const auto intercept = groups.decimals(0x0028, 0x9145, 0x0028, 0x1052);
  if (!slope.empty()) frame.slope = slope.front();
  if (!intercept.empty()) frame.intercept = intercept.front();
  const std::string type = groups.text(0x0028, 0x9145, 0x0028, 0x1054);
  if (!type.empty()) frame.rescale_type = type;
}

std::string& key(DicomFrame& frame, PlaneKey which) {
  return frame.keys.at(static_cast<std::size_t>(which));
}

/// Frame content, MR echo, MR diffusion, cardiac synchronisation, and the frame types of CT, MR and
/// PET.
void key_frame(DicomFrame& frame, const FrameGroups& groups) {
  key(frame, PlaneKey::temporal_position) = groups.binary_text(0x0020, 0x9111, 0x0020, 0x9128);
  key(frame, PlaneKey::stack) = groups.text(0x0020, 0x9111, 0x0020, 0x9056);
  key(frame, PlaneKey::acquisition_number) = groups.binary_text(0x0020, 0x9111, 0x0020, 0x9156);
  key(frame, PlaneKey::acquisition_time) = groups.text(0x0020, 0x9111, 0x0018, 0x9074);
  key(frame, PlaneKey::echo_time) = groups.binary_text(0x0018, 0x9114, 0x0018, 0x9082);
  key(frame, PlaneKey::b_value) = groups.binary_text(0x0018, 0x9117, 0x0018, 0x9087);
  key(frame, PlaneKey::trigger_time) = groups.binary_text(0x0018, 0x9118, 0x0020, 0x9153);
  constexpr std::array<std::uint16_t, 3> kFrameTypes{0x9226, 0x9329, 0x9751};
  for (const std::uint16_t macro : kFrameTypes) {
    const std::string type = groups.text(0x0018, macro, 0x0008, 0x9007);
    if (!type.empty()) key(frame, PlaneKey::image_type) = type;
  }
}

}  // namespace

bool has_functional_groups(const gdcm::DataSet& data) {
  return data.FindDataElement(gdcm::Tag(0x5200, 0x9230));
}

std::vector<DicomFrame> enhanced_frames(const DicomFrame& common, const gdcm::DataSet& data) {
  const gdcm::DataSet shared = first_item_at(data, 0x5200, 0x9229).value_or(gdcm::DataSet());
  const auto per_frame = sequence_at(data, 0x5200, 0x9230);
  const std::size_t count = per_frame->GetNumberOfItems();
  const auto declared = decimals_at(data, 0x0028, 0x0008);
  if (count == 0 || declared.size() != 1 || declared.front() != static_cast<double>(count)) {
    refuse(common.file, "the number of frames is unclear",
           fmt::format("NumberOfFrames = {}, the number of per-frame groups", count),
           declared.empty() ? "none" : number_in_words(declared.front()));
  }
  std::vector<DicomFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    DicomFrame& frame = frames.emplace_back(common);
    frame.index = static_cast<int>(i);
    frame.frames_in_file = static_cast<int>(count);
    const FrameGroups groups(shared, per_frame->GetItem(i + 1).GetNestedDataSet());
    place_frame(frame, groups);
    rescale_frame(frame, groups);
    key_frame(frame, groups);
  }
  return frames;
}

}  // namespace cutaway::reading
