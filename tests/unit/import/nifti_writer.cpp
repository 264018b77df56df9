#include "unit/import/nifti_writer.h"

#include "unit/import/import_test_support.h"

namespace cutaway::test {

namespace {

template <typename T>
void put(std::string& bytes, std::size_t offset, T number, bool big_endian) {
  const std::string raw = bytes_of_numbers<T>({number}, big_endian);
  bytes.replace(offset, raw.size(), raw);
}

std::string header_1(const NiftiFile& file) {
  std::string bytes(352, '\0');
  const auto f32 = [&](std::size_t at, double v) {
    put(bytes, at, static_cast<float>(v), file.big_endian);
  };
  const auto i16 = [&](std::size_t at, std::int64_t v) {
    put(bytes, at, static_cast<std::int16_t>(v), file.big_endian);
  };
  put<std::int32_t>(bytes, 0, 348, file.big_endian);
  i16(40, static_cast<std::int64_t>(file.dim.size()));
  for (std::size_t i = 0; i < file.dim.size(); ++i) i16(42 + 2 * i, file.dim[i]);
  i16(70, file.datatype);
  for (std::size_t i = 0; i < 8; ++i) f32(76 + 4 * i, file.pixdim[i]);
  f32(108, file.voxel_offset.value_or(file.magic[1] == '+' ? 352 : 0));
  f32(112, file.slope);
  f32(116, file.intercept);
  bytes[123] = static_cast<char>(file.units);
  i16(252, file.qform_code);
  i16(254, file.sform_code);
  for (int i = 0; i < 3; ++i) f32(256 + 4 * i, file.quaternion[i]);
  for (int i = 0; i < 3; ++i) f32(268 + 4 * i, file.q_offset[i]);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      f32(280 + 16 * row + 4 * column, file.s_steps[column][row]);
    f32(280 + 16 * row + 12, file.s_origin[row]);
  }
  bytes.replace(344, file.magic.size(), file.magic);
  return bytes;
}

std::string header_2(const NiftiFile& file) {
  std::string bytes(544, '\0');
  const auto f64 = [&](std::size_t at, double v) { put(bytes, at, v, file.big_endian); };
  put<std::int32_t>(bytes, 0, 540, file.big_endian);
  bytes.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
  put(bytes, 12, file.datatype, file.big_endian);
  put(bytes, 16, static_cast<std::int64_t>(file.dim.size()), file.big_endian);
  for (std::size_t i = 0; i < file.dim.size(); ++i)
    put(bytes, 24 + 8 * i, file.dim[i], file.big_endian);
  for (std::size_t i = 0; i < 8; ++i) f64(104 + 8 * i, file.pixdim[i]);
  put(bytes, 168, static_cast<std::int64_t>(file.voxel_offset.value_or(544)), file.big_endian);
  f64(176, file.slope);
  f64(184, file.intercept);
  put<std::int32_t>(bytes, 344, file.qform_code, file.big_endian);
  put<std::int32_t>(bytes, 348, file.sform_code, file.big_endian);
  for (int i = 0; i < 3; ++i) f64(352 + 8 * i, file.quaternion[i]);
  for (int i = 0; i < 3; ++i) f64(376 + 8 * i, file.q_offset[i]);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      f64(400 + 32 * row + 8 * column, file.s_steps[column][row]);
    f64(400 + 32 * row + 24, file.s_origin[row]);
  }
  put<std::int32_t>(bytes, 500, file.units, file.big_endian);
  return bytes;
}

}  // namespace

std::string NiftiFile::header() const { return version == 2 ? header_2(*this) : header_1(*this); }

std::string NiftiFile::ramp_voxels() const {
  const glm::dmat3 ras_to_lps(-1, 0, 0, 0, -1, 0, 0, 0, 1);
  const glm::ivec3 size(dim[0], dim[1], dim[2]);
  const auto values = ramp_values(size, ras_to_lps * s_steps, ras_to_lps * s_origin);
  return bytes_of_numbers(std::vector<float>(values.begin(), values.end()), big_endian);
}

}  // namespace cutaway::test
