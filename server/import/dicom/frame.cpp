#include "import/dicom/frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdcmMediaStorage.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <cmath>
#include <fstream>
#include <mutex>

#include "import/data_root.h"
#include "import/dicom/dataset.h"
#include "import/dicom/elements.h"
#include "import/dicom/functional_groups.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

/// GDCM prints to standard error; what matters of it comes back as a refusal.
void silence_gdcm() {
  static std::once_flag once;
  std::call_once(once, [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  });
}

std::string first_text(const gdcm::DataSet& data,
                       std::initializer_list<std::pair<std::uint16_t, std::uint16_t>> tags) {
  for (const auto& [group, element] : tags) {
    if (std::string text = text_at(data, group, element); !text.empty()) return text;
  }
  return {};
}

std::string title_of(const gdcm::DataSet& data) {
  std::string described = first_text(data, {{0x0008, 0x103e}, {0x0008, 0x1030}, {0x0018, 0x1030}});
  if (!described.empty()) return quoted_briefly(described);
  return printable(text_at(data, 0x0008, 0x0060) + " " + text_at(data, 0x0018, 0x0015));
}

Component component_of(const fs::path& file, const gdcm::DataSet& data) {
  const int allocated = static_cast<int>(binary_at(data, 0x0028, 0x0100).value_or(0));
  const bool is_signed = binary_at(data, 0x0028, 0x0103).value_or(0) == 1;
  if (allocated == 8) return is_signed ? Component::int8 : Component::uint8;
  if (allocated == 16) return is_signed ? Component::int16 : Component::uint16;
  if (allocated == 32) return is_signed ? Component::int32 : Component::uint32;
  refuse(file, "this pixel size is not read", "8, 16 or 32 bits allocated",
         fmt::format("{} bits", allocated));
}

void require_grey_planes(const fs::path& file, const gdcm::DataSet& data) {
  const std::string colours = text_at(data, 0x0028, 0x0004);
  if (binary_at(data, 0x0028, 0x0002).value_or(1) != 1 || !colours.starts_with("MONOCHROME")) {
    refuse(file, "colour images are not read as a volume", "MONOCHROME1 or MONOCHROME2", colours);
  }
  if (text_at(data, 0x0008, 0x0008).find("MOSAIC") != std::string::npos) {
    refuse(file, "a mosaic of slices in one picture is not read",
           "one slice a picture, or enhanced multi-frame");
  }
}

/// The first of the windows that the file offers. Source: DICOM PS3.3, C.11.2.1.2.
std::optional<ValueRange> window_of(const gdcm::DataSet& data) {
  const auto centres = decimals_at(data, 0x0028, 0x1050);
  const auto widths = decimals_at(data, 0x0028, 0x1051);
  if (centres.empty() || widths.empty()) return std::nullopt;
  const double half_width = 0.5 * widths.front();
  const ValueRange window{centres.front() - half_width, centres.front() + half_width};
  const bool is_usable = std::isfinite(window.minimum) && std::isfinite(window.maximum) &&
                         window.maximum > window.minimum;
  return is_usable ? std::optional(window) : std::nullopt;
}

/// What holds for all planes of the file, and the plane's own place where it has only one.
DicomFrame common_frame(const fs::path& file, const gdcm::DataSet& data) {
  DicomFrame frame;
  frame.file = file;
  frame.series_uid = text_at(data, 0x0020, 0x000e);
  frame.instance_uid = text_at(data, 0x0008, 0x0018);
  frame.modality = text_at(data, 0x0008, 0x0060);
  frame.title = title_of(data);
  frame.rescale_type = text_at(data, 0x0028, 0x1054);
  frame.is_localizer = text_at(data, 0x0008, 0x0008).find("LOCALIZER") != std::string::npos;
  frame.low_is_bright = text_at(data, 0x0028, 0x0004) == "MONOCHROME1";
  frame.component = component_of(file, data);
  frame.padding = pixel_padding(data);
  frame.window = window_of(data);
  frame.size_px = {static_cast<int>(binary_at(data, 0x0028, 0x0011).value_or(0)),
                   static_cast<int>(binary_at(data, 0x0028, 0x0010).value_or(0))};
  return frame;
}

std::array<std::string, kPlaneKeys> keys_of(const gdcm::DataSet& data) {
  return {text_at(data, 0x0018, 0x0086),
          text_at(data, 0x0020, 0x0100),
          "",
          text_at(data, 0x0018, 0x0081),
          first_text(data, {{0x0018, 0x9087}}),
          text_at(data, 0x0018, 0x1060),
          text_at(data, 0x0020, 0x0012),
          text_at(data, 0x0008, 0x0008),
          first_text(data, {{0x0008, 0x0032}, {0x0008, 0x002a}}),
          text_at(data, 0x0008, 0x0033)};
}

std::vector<double> required_decimals(const fs::path& file, const gdcm::DataSet& data, int group,
                                      int element, std::size_t count, const char* name) {
  std::vector<double> numbers =
      decimals_at(data, static_cast<std::uint16_t>(group), static_cast<std::uint16_t>(element));
  if (are_finite(numbers, count)) return numbers;
  refuse(file, fmt::format("the image has no usable {}", name),
         fmt::format("{} finite numbers", count), fmt::format("{}", fmt::join(numbers, ", ")));
}

DicomFrame single_frame(const fs::path& file, const gdcm::DataSet& data) {
  DicomFrame frame = common_frame(file, data);
  frame.keys = keys_of(data);
  const auto position = required_decimals(file, data, 0x0020, 0x0032, 3, "ImagePositionPatient");
  const auto axes = required_decimals(file, data, 0x0020, 0x0037, 6, "ImageOrientationPatient");
  const auto spacing = required_decimals(file, data, 0x0028, 0x0030, 2, "PixelSpacing");
  frame.position_mm = {position[0], position[1], position[2]};
  frame.row_axis = {axes[0], axes[1], axes[2]};
  frame.column_axis = {axes[3], axes[4], axes[5]};
  frame.spacing_mm = {spacing[1], spacing[0]};  // the file gives rows' distance first
  const auto slope = decimals_at(data, 0x0028, 0x1053);
  const auto intercept = decimals_at(data, 0x0028, 0x1052);
  if (!slope.empty()) frame.slope = slope.front();
  if (!intercept.empty()) frame.intercept = intercept.front();
  return frame;
}

/// An uncompressed file must be long enough for its pixels.
void require_file_size(const fs::path& file, const gdcm::File& dicom, const DicomFrame& frame,
                       std::size_t frames) {
  const gdcm::TransferSyntax& syntax = dicom.GetHeader().GetDataSetTransferSyntax();
  if (syntax.IsEncapsulated() || syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian)
    return;
  const double needed = static_cast<double>(component_bytes(frame.component)) * frame.size_px.x *
                        frame.size_px.y * static_cast<double>(frames);
  std::error_code failed;
  const auto available = static_cast<double>(fs::file_size(file, failed));
  if (!failed && available < needed) {
    refuse(file, "the file is shorter than its header says", bytes_in_words(needed),
           bytes_in_words(available));
  }
}

/// The class of a file that ends too soon may still stand in its header.
std::string storage_class(const gdcm::File& dicom) {
  const std::string own = text_at(dicom.GetDataSet(), 0x0008, 0x0016);
  return own.empty() ? text_at(dicom.GetHeader(), 0x0002, 0x0002) : own;
}

bool is_image(const fs::path& file, const gdcm::File& dicom) {
  const gdcm::DataSet& data = dicom.GetDataSet();
  if (binary_at(data, 0x0028, 0x0010).value_or(0) > 0 &&
      binary_at(data, 0x0028, 0x0011).value_or(0) > 0) {
    return true;
  }
  const std::string storage = storage_class(dicom);
  if (storage.starts_with("1.2.840.10008.5.1.4.1.1.2") ||
      storage.starts_with("1.2.840.10008.5.1.4.1.1.4")) {
    refuse(file, "the image has no usable size", "Rows and Columns above 0");
  }
  return false;
}

std::vector<DicomFrame> frames_of(const fs::path& file, const gdcm::File& dicom) {
  const gdcm::DataSet& data = dicom.GetDataSet();
  if (!is_image(file, dicom)) return {};
  require_grey_planes(file, data);
  std::vector<DicomFrame> frames;
  if (has_functional_groups(data)) {
    frames = enhanced_frames(common_frame(file, data), data);
  } else {
    const auto count = decimals_at(data, 0x0028, 0x0008);
    if (!count.empty() && count.front() > 1) {
      refuse(file, "several frames in one file without a place for each are not read",
             "enhanced multi-frame DICOM with functional groups");
    }
    frames.push_back(single_frame(file, data));
  }
  require_file_size(file, dicom, frames.front(), frames.size());
  return frames;
}

}  // namespace

std::string_view name_of(PlaneKey key) {
  constexpr std::array<std::string_view, kPlaneKeys> kNames{
      "echo",         "time",        "stack",      "echo time",        "b-value",
      "trigger time", "acquisition", "image type", "acquisition time", "content time"};
  return kNames.at(static_cast<std::size_t>(key));
}

std::vector<DicomFrame> read_dicom_frames(const fs::path& file) {
  silence_gdcm();
  try {
    require_whole_elements(file);
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    const gdcm::Tag pixel_data(0x7fe0, 0x0010);
    if (!reader.ReadUpToTag(pixel_data, {pixel_data})) {
      refuse(file, "the DICOM header is broken or cut off");
    }
    return frames_of(file, reader.GetFile());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {  // GDCM's own, of streams, of memory
    refuse(file, "the DICOM header is broken", {}, printable(error.what()));
  }
}

bool has_dicom_magic(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  std::array<char, 4> magic{};
  input.seekg(128);
  input.read(magic.data(), magic.size());
  return input && std::string_view(magic.data(), magic.size()) == "DICM";
}

}  // namespace cutaway::reading
