#include "import/dicom/image.h"

#include <fmt/format.h>

#include "import/data_root.h"
#include "import/dicom/transfer_syntax.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

constexpr DicomTag kRows = 0x00280010;
constexpr DicomTag kColumns = 0x00280011;
constexpr DicomTag kModality = 0x00080060;
constexpr DicomTag kImageType = 0x00080008;

std::string title_of(const DataSet& data) {
  const std::string described = data.first_text({0x0008103e, 0x00081030, 0x00181030});
  if (!described.empty()) return quoted_briefly(described);
  return printable(data.text(kModality) + " " + data.text(0x00180015));
}

Component component_of(const fs::path& file, const DicomHeader& header, const DataSet& data) {
  if (header.pixels && header.pixels->tag == 0x7FE00008) return Component::float32;
  if (header.pixels && header.pixels->tag == 0x7FE00009) return Component::float64;
  const int allocated = static_cast<int>(data.binary(0x00280100).value_or(0));
  const bool is_signed = data.binary(0x00280103).value_or(0) == 1;
  if (allocated == 8) return is_signed ? Component::int8 : Component::uint8;
  if (allocated == 16) return is_signed ? Component::int16 : Component::uint16;
  if (allocated == 32) return is_signed ? Component::int32 : Component::uint32;
  refuse(file, "this pixel size is not read", "8, 16 or 32 bits allocated",
         fmt::format("{} bits", allocated));
}

void require_grey_planes(const fs::path& file, const DataSet& data) {
  const std::string colours = data.text(0x00280004);
  if (data.binary(0x00280002).value_or(1) != 1 || !colours.starts_with("MONOCHROME")) {
    refuse(file, "colour images are not read as a volume", "MONOCHROME1 or MONOCHROME2", colours);
  }
  if (data.text(kImageType).find("MOSAIC") != std::string::npos) {
    refuse(file, "a mosaic of slices in one picture is not read",
           "one slice a picture, or enhanced multi-frame");
  }
}

/// An object that may hold rows and columns without being a picture of the body, or none at all.
void require_image(const fs::path& file, const DicomHeader& header, const DataSet& data) {
  const std::string own = data.text(0x00080016);
  const std::string storage = own.empty() ? header.storage_class : own;
  if (const std::string_view object = object_in_words(storage); !object.empty())
    refuse(file, fmt::format("this is {}, not an image series", object));
  if (data.binary(kRows).value_or(0) > 0 && data.binary(kColumns).value_or(0) > 0) return;
  if (header.pixels || data.has(kRows) || storage.starts_with("1.2.840.10008.5.1.4.1.1"))
    refuse(file, "the image has no usable size", "Rows and Columns above 0");
  refuse(file, "this DICOM file holds no image", "Rows and Columns", "class " + storage);
}

std::string folder_of(const fs::path& file) { return "in " + file.parent_path().string(); }

/// Exports differ in case and in empty components at the end.
std::string plain_name(const std::string& name) {
  std::string plain = lower_case(name);
  while (!plain.empty() && (plain.back() == '^' || plain.back() == ' ')) plain.pop_back();
  return plain;
}

/// "7" and "07" are one.
std::string series_number(const DataSet& data) {
  constexpr DicomTag kSeriesNumber = 0x00200011;
  const auto numbers = data.decimals(kSeriesNumber);
  return are_finite(numbers, 1) ? number_in_words(numbers.front()) : data.text(kSeriesNumber);
}

/// Series without an identifier are told apart by their folders.
std::array<std::string, kIdentities> identity_of(const fs::path& file, const DataSet& data) {
  const std::string series = data.text(0x0020000e);
  const bool is_localizer = data.text(kImageType).find("LOCALIZER") != std::string::npos;
  return {data.text(0x00100020), plain_name(data.text(0x00100010)),
          data.text(0x0020000d), series.empty() ? folder_of(file) : series,
          series_number(data),   data.text(0x00200052),
          data.text(kModality),  is_localizer ? "localizer" : "",
          data.text(0x00181210)};
}

}  // namespace

DicomImage dicom_image(const fs::path& file, const DicomHeader& header, const DataSet& data) {
  require_image(file, header, data);
  require_grey_planes(file, data);
  DicomImage image;
  image.file = file;
  image.identity = identity_of(file, data);
  image.transfer_syntax = header.transfer_syntax;
  image.title = title_of(data);
  image.low_is_bright = data.text(0x00280004) == "MONOCHROME1";
  image.component = component_of(file, header, data);
  image.padding = pixel_padding(data, image.component);
  image.size_px = {static_cast<int>(data.binary(kColumns).value_or(0)),
                   static_cast<int>(data.binary(kRows).value_or(0))};
  return image;
}

void require_pixels(const DicomImage& image, const DicomHeader& header, const ByteSource& source) {
  if (!header.pixels) {
    refuse(image.file, "the image has no pixel data, or is cut off before them");
  }
  required_packing(image.file, header.transfer_syntax, header.pixels->is_in_fragments);
  if (header.pixels->is_in_fragments) return;
  const double needed = static_cast<double>(component_bytes(image.component)) * image.size_px.x *
                        image.size_px.y * image.frames;
  double available = static_cast<double>(header.pixels->length);
  if (!header.is_partly_unpacked) {
    const std::uint64_t left = source.size() - header.pixels->offset;
    available = std::min(available, static_cast<double>(left));
  }
  if (available < needed) {
    refuse(image.file, "the file is shorter than its header says", bytes_in_words(needed),
           bytes_in_words(available));
  }
}

}  // namespace cutaway::reading
