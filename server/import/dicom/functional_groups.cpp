#include "import/dicom/functional_groups.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/dicom/placement.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr DicomTag kPerFrame = 0x52009230;
constexpr DicomTag kShared = 0x52009229;
constexpr std::size_t kMostFrames = 32768;  // as many slices as a volume may have

/// The data sets in which a frame's values may stand, the nearest first.
class FrameGroups {
 public:
  FrameGroups(const DataSet& data, const std::optional<DataSet>& shared, const DataSet& own)
      : data_(data), shared_(shared), own_(own) {}

  /// A macro of the frame's own, else of the shared ones.
  std::optional<DataSet> macro(DicomTag tag) const {
    if (auto item = own_.first_item(tag)) return item;
    return shared_ ? shared_->first_item(tag) : std::nullopt;
  }

  std::vector<DataSet> of(std::initializer_list<DicomTag> macros) const {
    std::vector<DataSet> found;
    for (const DicomTag tag : macros) {
      if (auto item = macro(tag)) found.push_back(*item);
    }
    found.push_back(data_);
    return found;
  }

  /// Those that hold a sequence themselves.
  std::vector<DataSet> levels() const {
    std::vector<DataSet> found{own_};
    if (shared_) found.push_back(*shared_);
    return found;
  }

  std::string number(DicomTag macro_tag, DicomTag tag) const {
    const auto item = macro(macro_tag);
    const auto value = item ? item->binary(tag) : std::nullopt;
    return value ? number_in_words(*value) : std::string();
  }

  std::string text(DicomTag macro_tag, DicomTag tag) const {
    const auto item = macro(macro_tag);
    return item ? item->text(tag) : std::string();
  }

 private:
  const DataSet& data_;
  const std::optional<DataSet>& shared_;
  const DataSet& own_;
};

std::string& key(DicomFrame& frame, PlaneKey which) {
  return frame.keys.at(static_cast<std::size_t>(which));
}

/// Frame content, MR echo, MR diffusion, cardiac synchronisation, CT exposure, and the frame types
/// of CT, MR and PET.
void key_frame(DicomFrame& frame, const FrameGroups& groups) {
  key(frame, PlaneKey::temporal_position) = groups.number(0x00209111, 0x00209128);
  key(frame, PlaneKey::stack) = groups.text(0x00209111, 0x00209056);
  key(frame, PlaneKey::acquisition_number) = groups.number(0x00209111, 0x00209156);
  key(frame, PlaneKey::acquisition_time) = groups.text(0x00209111, 0x00189074);
  key(frame, PlaneKey::echo_time) = groups.number(0x00189114, 0x00189082);
  key(frame, PlaneKey::b_value) = groups.number(0x00189117, 0x00189087);
  key(frame, PlaneKey::trigger_time) = groups.number(0x00189118, 0x00209153);
  key(frame, PlaneKey::cardiac_phase) = groups.number(0x00189118, 0x00209241);
  key(frame, PlaneKey::tube_voltage) = groups.text(0x00189325, 0x00180060);
  if (const auto diffusion = groups.macro(0x00189117)) {
    if (const auto gradient = diffusion->first_item(0x00189076))
      key(frame, PlaneKey::gradient_direction) =
          fmt::format("{}", fmt::join(gradient->binaries(0x00189089), ", "));
  }
  constexpr std::array<DicomTag, 3> kFrameTypes{0x00189226, 0x00189329, 0x00189751};
  for (const DicomTag macro : kFrameTypes) {
    const std::string type = groups.text(macro, 0x00089007);
    if (!type.empty()) key(frame, PlaneKey::image_type) = type;
  }
}

DicomFrame enhanced_frame(const std::shared_ptr<const DicomImage>& image, std::size_t index,
                          const DataSet& data, const FrameGroups& groups) {
  DicomFrame frame;
  frame.image = image;
  frame.index = static_cast<int>(index);
  place(frame, fmt::format("frame {}", index + 1), groups.of({0x00209113, 0x00209116, 0x00289110}));
  std::vector<DataSet> values = groups.levels();
  for (const auto& group : groups.of({0x00289145})) values.push_back(group);
  const bool is_hounsfield = image->of(Identity::modality) == "CT" && !image->is_localizer();
  frame.meaning = value_meaning(image->file, data, values, is_hounsfield);
  frame.window = window_of(groups.of({0x00289132}), frame.meaning);
  key_frame(frame, groups);
  const std::string& trigger = frame.key(PlaneKey::trigger_time);
  frame.moments = {moment_of(frame.key(PlaneKey::acquisition_time)),
                   trigger.empty() ? std::nullopt : std::optional(std::stod(trigger)), std::nullopt,
                   static_cast<double>(index)};
  return frame;
}

}  // namespace

bool has_functional_groups(const DataSet& data) { return data.has(kPerFrame); }

std::vector<DicomFrame> enhanced_frames(DicomImage image, const DataSet& data) {
  const std::optional<DataSet> shared = data.first_item(kShared);
  const std::vector<DataSet> per_frame = data.items(kPerFrame);
  const std::size_t count = per_frame.size();
  const auto declared = data.decimals(0x00280008);
  if (count == 0 || declared.size() != 1 || declared.front() != static_cast<double>(count)) {
    refuse(image.file, "the number of frames is unclear",
           fmt::format("NumberOfFrames = {}, the number of per-frame groups", count),
           declared.empty() ? "none" : number_in_words(declared.front()));
  }
  if (count > kMostFrames) {
    refuse(image.file, "there are too many frames in one file",
           fmt::format("at most {}", kMostFrames), fmt::format("{}", count));
  }
  image.frames = static_cast<int>(count);
  const auto shared_image = std::make_shared<const DicomImage>(std::move(image));
  std::vector<DicomFrame> frames;
  frames.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    frames.push_back(
        enhanced_frame(shared_image, i, data, FrameGroups(data, shared, per_frame[i])));
  return frames;
}

}  // namespace cutaway::reading
