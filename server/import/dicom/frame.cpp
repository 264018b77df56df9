#include "import/dicom/frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "import/data_root.h"
#include "import/dicom/functional_groups.h"
#include "import/dicom/image.h"
#include "import/dicom/placement.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// Not as text only: 100 comes behind 20, 12.5 behind 4.6.
std::string number_key(const DataSet& data, DicomTag tag) {
  const auto numbers = data.decimals(tag);
  return are_finite(numbers, 1) ? number_in_words(numbers.front()) : data.text(tag);
}

std::string binary_key(const DataSet& data, DicomTag tag) {
  const auto number = data.binary(tag);
  return number ? number_in_words(*number) : std::string();
}

/// Date and time in one, or either.
std::string time_key(const DataSet& data, DicomTag date_time, DicomTag date, DicomTag time) {
  std::string both = data.text(date_time);
  if (!both.empty()) return both;
  const std::string day = data.text(date);
  const std::string hour = data.text(time);
  return day.empty() || hour.empty() ? hour : day + " " + hour;
}

std::array<std::string, kPlaneKeys> keys_of(const DataSet& data) {
  const std::string diffusion = binary_key(data, 0x00189087);
  return {number_key(data, 0x00180086),
          number_key(data, 0x00200100),
          "",
          number_key(data, 0x00180081),
          diffusion,
          number_key(data, 0x00180082),
          number_key(data, 0x00181060),
          binary_key(data, 0x00209241),
          number_key(data, 0x00200012),
          data.text(0x00080008),
          data.text(0x0008103e),
          number_key(data, 0x00180060),
          number_key(data, 0x00181314),
          fmt::format("{}", fmt::join(data.binaries(0x00189089), ", ")),
          time_key(data, 0x0008002a, 0x00080022, 0x00080032),
          time_key(data, 0, 0x00080023, 0x00080033)};
}

DicomFrame single_frame(const std::shared_ptr<const DicomImage>& image, const DataSet& data) {
  DicomFrame frame;
  frame.image = image;
  frame.keys = keys_of(data);
  const bool is_hounsfield = image->of(Identity::modality) == "CT" && !image->is_localizer();
  frame.meaning = value_meaning(image->file, data, {data}, is_hounsfield);
  frame.window = window_of({data}, frame.meaning);
  place(frame, "the image", {data});
  frame.moments = {moment_of(frame.key(PlaneKey::acquisition_time)), data.decimal(0x00181060),
                   moment_of(frame.key(PlaneKey::content_time)), data.decimal(0x00200013)};
  return frame;
}

std::vector<DicomFrame> frames_of(DicomImage image, const DataSet& data) {
  if (has_functional_groups(data)) return enhanced_frames(std::move(image), data);
  if (data.decimal(0x00280008).value_or(1) > 1) {
    refuse(image.file, "several frames in one file without a place for each are not read",
           "enhanced multi-frame DICOM with functional groups");
  }
  return {single_frame(std::make_shared<const DicomImage>(std::move(image)), data)};
}

}  // namespace

std::string_view name_of(PlaneKey key) {
  constexpr std::array<std::string_view, kPlaneKeys> kNames{
      "echo",           "time",         "stack",         "echo time",   "b-value",
      "inversion time", "trigger time", "cardiac phase", "acquisition", "image type",
      "description",    "kV",           "flip angle",    "gradient",    "acquisition time",
      "content time"};
  return kNames.at(static_cast<std::size_t>(key));
}

std::vector<DicomFrame> read_dicom_frames(const fs::path& file) {
  ByteSource source(file);
  const DicomHeader header = read_dicom_header(source);
  const CharacterSet unknown;
  const CharacterSet characters(DataSet(source, header.data, unknown).raw(0x00080005));
  const DataSet data(source, header.data, characters);
  std::vector<DicomFrame> frames = frames_of(dicom_image(file, header, data), data);
  require_pixels(*frames.front().image, header, source);
  return frames;
}

}  // namespace cutaway::reading
