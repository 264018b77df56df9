#include "unit/import/dicom_writer.h"

#include <fmt/format.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "unit/import/import_test_support.h"

namespace cutaway::test {

namespace {

constexpr const char* kCtImage = "1.2.840.10008.5.1.4.1.1.2";
constexpr const char* kEnhancedCtImage = "1.2.840.10008.5.1.4.1.1.2.1";

void put_bytes(gdcm::DataSet& data, DicomTag tag, gdcm::VR vr, const std::string& bytes) {
  gdcm::DataElement element(gdcm::Tag(tag.first, tag.second));
  element.SetVR(vr);
  element.SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
  data.Replace(element);
}

void put_text(gdcm::DataSet& data, DicomTag tag, gdcm::VR vr, std::string text) {
  if (text.size() % 2 != 0) text += vr == gdcm::VR::UI ? '\0' : ' ';
  put_bytes(data, tag, vr, text);
}

void put_short(gdcm::DataSet& data, DicomTag tag, int number) {
  put_bytes(data, tag, gdcm::VR::US,
            bytes_of_numbers<std::uint16_t>({static_cast<std::uint16_t>(number)}));
}

void put_long(gdcm::DataSet& data, DicomTag tag, std::uint32_t number) {
  put_bytes(data, tag, gdcm::VR::UL, bytes_of_numbers<std::uint32_t>({number}));
}

void put_sequence(gdcm::DataSet& data, DicomTag tag, const std::vector<gdcm::DataSet>& items) {
  gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = new gdcm::SequenceOfItems;
  sequence->SetLengthToUndefined();
  for (const auto& nested : items) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(nested);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(gdcm::Tag(tag.first, tag.second));
  element.SetVR(gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  data.Replace(element);
}

std::string decimals(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : "\\") + fmt::format("{:.9g}", number);
  return text;
}

void put_position(gdcm::DataSet& data, const DicomSlice& slice) {
  put_text(data, {0x0020, 0x0032}, gdcm::VR::DS,
           decimals({slice.position_mm.x, slice.position_mm.y, slice.position_mm.z}));
}

void put_orientation(gdcm::DataSet& data, const DicomSlice& slice) {
  const glm::dvec3 r = slice.row_axis;
  const glm::dvec3 c = slice.column_axis;
  put_text(data, {0x0020, 0x0037}, gdcm::VR::DS, decimals({r.x, r.y, r.z, c.x, c.y, c.z}));
}

void put_spacing(gdcm::DataSet& data, const DicomSlice& slice) {
  put_text(data, {0x0028, 0x0030}, gdcm::VR::DS,
           decimals({slice.spacing_mm.y, slice.spacing_mm.x}));
}

void put_rescale(gdcm::DataSet& data, const DicomSlice& slice) {
  put_text(data, {0x0028, 0x1052}, gdcm::VR::DS, decimals({slice.intercept}));
  put_text(data, {0x0028, 0x1053}, gdcm::VR::DS, decimals({slice.slope}));
}

void put_table(gdcm::DataSet& data, const DicomTable& table) {
  gdcm::DataSet item;
  put_bytes(item, {0x0028, 0x3002}, gdcm::VR::US,
            bytes_of_numbers<std::uint16_t>({static_cast<std::uint16_t>(table.entries.size()),
                                             static_cast<std::uint16_t>(table.first_stored), 16}));
  put_text(item, {0x0028, 0x3004}, gdcm::VR::LO, table.type);
  put_bytes(item, {0x0028, 0x3006}, gdcm::VR::US, bytes_of_numbers(table.entries));
  put_sequence(data, {0x0028, 0x3000}, {item});
}

void put_mapping(gdcm::DataSet& data, const DicomMapping& mapping) {
  gdcm::DataSet unit;
  put_text(unit, {0x0008, 0x0100}, gdcm::VR::SH, mapping.unit);
  gdcm::DataSet item;
  put_sequence(item, {0x0040, 0x08ea}, {unit});
  put_bytes(item, {0x0040, 0x9224}, gdcm::VR::FD, bytes_of_numbers<double>({mapping.intercept}));
  put_bytes(item, {0x0040, 0x9225}, gdcm::VR::FD, bytes_of_numbers<double>({mapping.slope}));
  put_sequence(data, {0x0040, 0x9096}, {item});
}

void put_values(gdcm::DataSet& data, const DicomSlice& slice) {
  if (slice.mapping.slope != 0) put_mapping(data, slice.mapping);
  if (!slice.table.entries.empty()) {
    put_table(data, slice.table);
  } else if (slice.has_rescale) {
    put_rescale(data, slice);
  }
}

void put_pixels(gdcm::DataSet& data, const DicomSlice& slice) {
  if (!slice.floats.empty()) {
    put_bytes(data, {0x7fe0, 0x0008}, gdcm::VR::OF, bytes_of_numbers(slice.floats));
  } else if (!slice.doubles.empty()) {
    put_bytes(data, {0x7fe0, 0x0009}, gdcm::VR::OD, bytes_of_numbers(slice.doubles));
  } else {
    put_bytes(data, {0x7fe0, 0x0010}, gdcm::VR::OW, bytes_of_numbers(slice.stored));
  }
}

void put_pixel_module(gdcm::DataSet& data, const DicomSlice& slice) {
  put_short(data, {0x0028, 0x0002}, 1);
  put_text(data, {0x0028, 0x0004}, gdcm::VR::CS, "MONOCHROME2");
  put_short(data, {0x0028, 0x0010}, slice.size_px.y);
  put_short(data, {0x0028, 0x0011}, slice.size_px.x);
  const int allocated = !slice.floats.empty() ? 32 : !slice.doubles.empty() ? 64 : 16;
  put_short(data, {0x0028, 0x0100}, allocated);
  put_short(data, {0x0028, 0x0101}, slice.bits_stored);
  put_short(data, {0x0028, 0x0102}, slice.bits_stored - 1);
  put_short(data, {0x0028, 0x0103}, slice.is_signed ? 1 : 0);
}

void put_identity(gdcm::DataSet& data, const DicomSlice& slice, const char* storage,
                  const std::string& name) {
  put_text(data, {0x0008, 0x0016}, gdcm::VR::UI,
           slice.storage_class.empty() ? storage : slice.storage_class);
  put_text(data, {0x0008, 0x0018}, gdcm::VR::UI,
           fmt::format("1.2.826.9.{}", std::hash<std::string>()(name)));
  put_text(data, {0x0008, 0x0060}, gdcm::VR::CS, slice.modality);
  put_text(data, {0x0010, 0x0010}, gdcm::VR::PN, "Secret^Name");
  put_text(data, {0x0010, 0x0020}, gdcm::VR::LO, "SECRET-ID");
  put_text(data, {0x0020, 0x000d}, gdcm::VR::UI, "1.2.826.5");
  put_text(data, {0x0020, 0x000e}, gdcm::VR::UI, slice.series_uid);
}

gdcm::VR vr_of(const DicomSlice& slice, DicomTag tag) {
  static const std::map<DicomTag, gdcm::VR> kKinds{
      {{0x0008, 0x0005}, gdcm::VR::CS}, {{0x0020, 0x000d}, gdcm::VR::UI},
      {{0x0020, 0x000e}, gdcm::VR::UI}, {{0x0020, 0x0052}, gdcm::VR::UI},
      {{0x0020, 0x0011}, gdcm::VR::IS}, {{0x0018, 0x0050}, gdcm::VR::DS},
      {{0x0018, 0x1210}, gdcm::VR::SH}, {{0x0008, 0x0033}, gdcm::VR::TM},
      {{0x0008, 0x0008}, gdcm::VR::CS}, {{0x0008, 0x0018}, gdcm::VR::UI},
      {{0x0008, 0x0032}, gdcm::VR::TM}, {{0x0018, 0x0081}, gdcm::VR::DS},
      {{0x0018, 0x0086}, gdcm::VR::IS}, {{0x0020, 0x0012}, gdcm::VR::IS},
      {{0x0020, 0x0013}, gdcm::VR::IS}, {{0x0020, 0x0100}, gdcm::VR::IS},
      {{0x0020, 0x0032}, gdcm::VR::DS}, {{0x0028, 0x0004}, gdcm::VR::CS},
      {{0x0028, 0x0030}, gdcm::VR::DS}, {{0x0028, 0x0008}, gdcm::VR::IS}};
  if (const auto given = slice.vrs.find(tag); given != slice.vrs.end())
    return gdcm::VR::GetVRType(given->second.c_str());
  const auto found = kKinds.find(tag);
  return found == kKinds.end() ? gdcm::VR(gdcm::VR::LO) : found->second;
}

void put_extras(gdcm::DataSet& data, const DicomSlice& slice) {
  for (const auto& [tag, value, is_signed] : slice.shorts) {
    put_bytes(data, tag, is_signed ? gdcm::VR::SS : gdcm::VR::US,
              bytes_of_numbers<std::uint16_t>({static_cast<std::uint16_t>(value)}));
  }
  for (const auto& [tag, text] : slice.texts) {
    if (text.empty()) {
      data.Remove(gdcm::Tag(tag.first, tag.second));
    } else {
      put_text(data, tag, vr_of(slice, tag), text);
    }
  }
}

void write(const std::filesystem::path& file, const gdcm::DataSet& data) {
  std::filesystem::create_directories(file.parent_path());
  gdcm::Writer writer;
  writer.SetFileName(file.c_str());
  writer.GetFile().SetDataSet(data);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(
      gdcm::TransferSyntax::ExplicitVRLittleEndian);
  ASSERT_TRUE(writer.Write()) << file;
}

gdcm::TransferSyntax::TSType type_of(Syntax syntax) {
  switch (syntax) {
    case Syntax::explicit_little:
      return gdcm::TransferSyntax::ExplicitVRLittleEndian;
    case Syntax::implicit:
      return gdcm::TransferSyntax::ImplicitVRLittleEndian;
    case Syntax::big_endian:
      return gdcm::TransferSyntax::ExplicitVRBigEndian;
    case Syntax::deflated:
      return gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian;
    case Syntax::rle:
      return gdcm::TransferSyntax::RLELossless;
    case Syntax::jpeg_lossless:
      return gdcm::TransferSyntax::JPEGLosslessProcess14_1;
    case Syntax::jpeg_ls:
      return gdcm::TransferSyntax::JPEGLSLossless;
    case Syntax::jpeg_2000:
      break;
  }
  return gdcm::TransferSyntax::JPEG2000Lossless;
}

}  // namespace

void DicomSlice::fill_with_ramp() {
  stored.clear();
  for (int row = 0; row < size_px.y; ++row) {
    for (int column = 0; column < size_px.x; ++column) {
      const glm::dvec3 place =
          position_mm + row_axis * (column * spacing_mm.x) + column_axis * (row * spacing_mm.y);
      stored.push_back(
          static_cast<std::int16_t>(std::lround((patient_ramp(place) - intercept) / slope)));
    }
  }
}

void write_dicom(const std::filesystem::path& file, const DicomSlice& slice) {
  gdcm::DataSet data;
  put_identity(data, slice, kCtImage, file.string());
  put_position(data, slice);
  put_orientation(data, slice);
  put_spacing(data, slice);
  put_values(data, slice);
  put_pixel_module(data, slice);
  put_pixels(data, slice);
  put_extras(data, slice);
  write(file, data);
}

void strip_file_header(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  constexpr std::size_t kGroupLength = 132 + 8;  // its value says how long the rest of group 2 is
  std::uint32_t rest = 0;
  std::memcpy(&rest, bytes.data() + kGroupLength, sizeof(rest));
  write_file(file, bytes.substr(kGroupLength + sizeof(rest) + rest));
}

void rename_syntax(const std::filesystem::path& file, const std::string& uid) {
  std::string bytes = read_file(file);
  const std::string head("\x02\0\x10\0UI", 6);
  const std::size_t place = bytes.find(head) + head.size();
  std::uint16_t length = 0;
  std::memcpy(&length, bytes.data() + place, sizeof(length));
  std::string value = uid + (uid.size() % 2 == 1 ? std::string(1, '\0') : "");
  const auto new_length = static_cast<std::uint16_t>(value.size());
  bytes.replace(place, sizeof(length) + length,
                std::string(reinterpret_cast<const char*>(&new_length), 2) + value);
  write_file(file, bytes);
}

void transcode(const std::filesystem::path& file, Syntax syntax) {
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(type_of(syntax));
  change.SetInput(reader.GetImage());
  ASSERT_TRUE(change.Change());
  gdcm::ImageWriter writer;
  writer.SetFileName(file.c_str());
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  ASSERT_TRUE(writer.Write());
}

void write_enhanced_dicom(const std::filesystem::path& file, const std::vector<DicomSlice>& frames,
                          const std::vector<std::uint32_t>& temporal_positions,
                          bool rescale_is_common) {
  const DicomSlice& first = frames.front();
  gdcm::DataSet data;
  put_identity(data, first, kEnhancedCtImage, file.string());
  put_pixel_module(data, first);
  put_text(data, {0x0028, 0x0008}, gdcm::VR::IS, std::to_string(frames.size()));
  if (rescale_is_common) put_rescale(data, first);
  gdcm::DataSet orientation;
  put_orientation(orientation, first);
  gdcm::DataSet measures;
  put_spacing(measures, first);
  gdcm::DataSet shared;
  put_sequence(shared, {0x0020, 0x9116}, {orientation});
  put_sequence(shared, {0x0028, 0x9110}, {measures});
  put_sequence(data, {0x5200, 0x9229}, {shared});
  std::vector<gdcm::DataSet> groups;
  std::string pixels;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    gdcm::DataSet position;
    put_position(position, frames[i]);
    gdcm::DataSet rescale;
    put_rescale(rescale, frames[i]);
    gdcm::DataSet& group = groups.emplace_back();
    put_sequence(group, {0x0020, 0x9113}, {position});
    if (!rescale_is_common) put_sequence(group, {0x0028, 0x9145}, {rescale});
    if (!temporal_positions.empty()) {
      gdcm::DataSet content;
      put_long(content, {0x0020, 0x9128}, temporal_positions[i]);
      put_sequence(group, {0x0020, 0x9111}, {content});
    }
    pixels += bytes_of_numbers(frames[i].stored);
  }
  put_sequence(data, {0x5200, 0x9230}, groups);
  put_bytes(data, {0x7fe0, 0x0010}, gdcm::VR::OW, pixels);
  put_extras(data, first);
  write(file, data);
}

std::vector<DicomSlice> ramp_series(int count, glm::dvec3 first, glm::dvec3 step,
                                    const DicomSlice& like) {
  std::vector<DicomSlice> slices;
  for (int k = 0; k < count; ++k) {
    DicomSlice& slice = slices.emplace_back(like);
    slice.position_mm = first + step * static_cast<double>(k);
    slice.texts[{0x0020, 0x0013}] = std::to_string((k * 7) % count);
    slice.fill_with_ramp();
  }
  return slices;
}

void write_series(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices,
                  const std::string& prefix) {
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const std::size_t scrambled = (k * 5 + 3) % slices.size();
    write_dicom(
        folder / (prefix + std::to_string(1000 + scrambled) + "-" + std::to_string(k) + ".dcm"),
        slices[k]);
  }
}

DicomSlice ramp_slice(glm::dvec3 row, glm::dvec3 column) {
  DicomSlice slice;
  slice.size_px = {7, 5};
  slice.spacing_mm = {0.75, 1.25};
  slice.row_axis = glm::normalize(row);
  slice.column_axis = glm::normalize(column - slice.row_axis * glm::dot(slice.row_axis, column));
  slice.slope = 0.125;
  slice.intercept = 900;
  return slice;
}

std::vector<DicomSlice> with_text(std::vector<DicomSlice> slices, DicomTag tag,
                                  const std::string& text) {
  for (auto& slice : slices) slice.texts[tag] = text;
  return slices;
}

}  // namespace cutaway::test
