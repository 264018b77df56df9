#include "import/grids/nifti_header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::int32_t kHeaderBytes1 = 348;
constexpr std::int32_t kHeaderBytes2 = 540;

/// Numbers at fixed offsets, in the file's byte order.
class Fields {
 public:
  Fields(std::span<const std::byte> bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}

  template <typename T>
  T at(std::size_t offset) const {
    std::array<std::byte, sizeof(T)> raw{};
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  template <typename T, typename Out, std::size_t N>
  void fill(std::array<Out, N>& values, std::size_t offset) const {
    for (std::size_t i = 0; i < N; ++i) values[i] = static_cast<Out>(at<T>(offset + i * sizeof(T)));
  }

  std::string_view text(std::size_t offset, std::size_t length) const {
    return {reinterpret_cast<const char*>(bytes_.data()) + offset, length};
  }

 private:
  std::span<const std::byte> bytes_;
  bool swapped_;
};

/// In a single file the voxels follow the header and four bytes that announce extensions. Writers
/// that leave the offset 0 mean the first place where they can be.
std::uint64_t checked_offset(const std::filesystem::path& file, double offset, bool single_file,
                             std::int32_t header_bytes) {
  const double least = single_file ? header_bytes + 4 : 0;
  if (offset == 0) offset = least;
  if (std::isfinite(offset) && offset >= least && offset < 1e9)
    return static_cast<std::uint64_t>(offset);
  refuse(file, "the offset of the voxels (vox_offset) is not usable",
         "0, or from " + number_in_words(least) + " bytes on", number_in_words(offset));
}

NiftiHeader parse_version_1(const std::filesystem::path& file, const Fields& fields) {
  NiftiHeader header;
  const std::string_view magic = fields.text(344, 4);
  if (magic != std::string_view("n+1\0", 4) && magic != std::string_view("ni1\0", 4)) {
    refuse(file, "not a NIfTI header (Analyze 7.5 files say too little of their orientation)",
           "the magic n+1 or ni1");
  }
  header.single_file = magic[1] == '+';
  fields.fill<std::int16_t>(header.dim, 40);
  header.datatype = fields.at<std::int16_t>(70);
  fields.fill<float>(header.pixdim, 76);
  header.voxel_offset =
      checked_offset(file, fields.at<float>(108), header.single_file, kHeaderBytes1);
  header.slope = fields.at<float>(112);
  header.intercept = fields.at<float>(116);
  header.length_unit = fields.at<std::uint8_t>(123) & 7;
  header.qform_code = fields.at<std::int16_t>(252);
  header.sform_code = fields.at<std::int16_t>(254);
  fields.fill<float>(header.quaternion_bcd, 256);
  fields.fill<float>(header.qform_offset, 268);
  fields.fill<float>(header.sform, 280);
  return header;
}

NiftiHeader parse_version_2(const std::filesystem::path& file, const Fields& fields) {
  NiftiHeader header;
  const std::string_view magic = fields.text(4, 8);
  const std::string_view rest("\0\r\n\032\n", 5);
  if ((magic.substr(0, 3) != "n+2" && magic.substr(0, 3) != "ni2") || magic.substr(3) != rest) {
    refuse(file, "not a NIfTI-2 header", "the magic n+2 or ni2");
  }
  header.single_file = magic[1] == '+';
  header.datatype = fields.at<std::int16_t>(12);
  fields.fill<std::int64_t>(header.dim, 16);
  fields.fill<double>(header.pixdim, 104);
  header.voxel_offset = checked_offset(file, static_cast<double>(fields.at<std::int64_t>(168)),
                                       header.single_file, kHeaderBytes2);
  header.slope = fields.at<double>(176);
  header.intercept = fields.at<double>(184);
  header.qform_code = fields.at<std::int32_t>(344);
  header.sform_code = fields.at<std::int32_t>(348);
  fields.fill<double>(header.quaternion_bcd, 352);
  fields.fill<double>(header.qform_offset, 376);
  fields.fill<double>(header.sform, 400);
  header.length_unit = fields.at<std::int32_t>(500) & 7;
  return header;
}

void require_dimensions(const std::filesystem::path& file, const NiftiHeader& header) {
  if (header.dim[0] < 1 || header.dim[0] > 7) {
    refuse(file, "the number of dimensions is not usable", "1 to 7", std::to_string(header.dim[0]));
  }
}

double millimetres_per_unit(int length_unit) {
  if (length_unit == 1) return 1000.0;
  if (length_unit == 3) return 0.001;
  return 1.0;
}

glm::dvec3 checked_pixdim(const std::filesystem::path& file, const NiftiHeader& header) {
  for (std::size_t axis = 1; axis <= 3; ++axis) {
    const double spacing = header.pixdim[axis];
    if (std::isfinite(spacing) && spacing > 0) continue;
    refuse(file, "the voxel spacing is not usable", "numbers above 0 in pixdim",
           number_in_words(spacing));
  }
  return {header.pixdim[1], header.pixdim[2], header.pixdim[3]};
}

/// nifti1.h, "METHOD 2": a unit quaternion, then the spacing; qfac (pixdim[0]) mirrors the third
/// axis.
NiftiAffine affine_of_qform(const std::filesystem::path& file, const NiftiHeader& header) {
  const glm::dvec3 spacing = checked_pixdim(file, header);
  const auto& [b, c, d] = header.quaternion_bcd;
  const double squares = b * b + c * c + d * d;
  if (!(squares < 1.001)) {
    refuse(file, "the qform's quaternion is not one of a rotation", "b^2 + c^2 + d^2 of at most 1",
           number_in_words(squares));
  }
  const double a = std::sqrt(std::max(0.0, 1.0 - squares));
  const double qfac = header.pixdim[0] < 0 ? -1.0 : 1.0;
  NiftiAffine affine;
  affine.steps_mm[0] = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
  affine.steps_mm[1] = {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)};
  affine.steps_mm[2] = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c};
  // b, c, d are rounded to float in the file, so the columns are a shade off unit length.
  for (int axis = 0; axis < 3; ++axis)
    affine.steps_mm[axis] = glm::normalize(affine.steps_mm[axis]) * spacing[axis];
  affine.steps_mm[2] *= qfac;
  affine.origin_mm = {header.qform_offset[0], header.qform_offset[1], header.qform_offset[2]};
  return affine;
}

NiftiAffine affine_of_sform(const NiftiHeader& header) {
  NiftiAffine affine;
  for (int row = 0; row < 3; ++row) {
    const double* values = header.sform.data() + std::ptrdiff_t{4} * row;
    for (int column = 0; column < 3; ++column) affine.steps_mm[column][row] = values[column];
    affine.origin_mm[row] = values[3];
  }
  return affine;
}

bool is_usable(const NiftiAffine& affine) {
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(affine.steps_mm[axis]);
    if (!std::isfinite(length) || length <= 0 || !std::isfinite(affine.origin_mm[axis]))
      return false;
  }
  return true;
}

std::optional<NiftiAffine> usable(const NiftiAffine& affine) {
  constexpr double kFlat = 1e-6;
  if (!is_usable(affine)) return std::nullopt;
  glm::dmat3 directions = affine.steps_mm;
  for (int axis = 0; axis < 3; ++axis) directions[axis] = glm::normalize(directions[axis]);
  return std::abs(glm::determinant(directions)) > kFlat ? std::optional(affine) : std::nullopt;
}

NiftiAffine affine_of_pixdim(const std::filesystem::path& file, const NiftiHeader& header) {
  NiftiAffine affine;
  const glm::dvec3 spacing = checked_pixdim(file, header);
  for (int axis = 0; axis < 3; ++axis) affine.steps_mm[axis][axis] = spacing[axis];
  return affine;
}

/// Nothing where the code says that there is none, or it is not usable.
std::optional<NiftiAffine> sform_of(const NiftiHeader& header) {
  if (header.sform_code <= 0) return std::nullopt;
  return usable(affine_of_sform(header));
}

std::optional<NiftiAffine> qform_of(const std::filesystem::path& file, const NiftiHeader& header) {
  if (header.qform_code <= 0) return std::nullopt;
  try {
    return usable(affine_of_qform(file, header));
  } catch (const Error&) {
    return std::nullopt;
  }
}

NiftiAffine affine_as_stored(const std::filesystem::path& file, const NiftiHeader& header) {
  if (auto sform = sform_of(header)) return *sform;
  if (auto qform = qform_of(file, header)) {
    if (header.sform_code > 0)
      qform->warnings.emplace_back("the sform is not usable; the qform was taken");
    return *qform;
  }
  if (header.qform_code > 0 && header.sform_code <= 0) return affine_of_qform(file, header);
  if (header.sform_code > 0) return affine_of_sform(header);
  NiftiAffine affine = affine_of_pixdim(file, header);
  affine.warnings.emplace_back(
      "neither sform nor qform is set: no position in the patient; i, j, k taken as right, "
      "anterior, superior");
  return affine;
}

}  // namespace

NiftiHeader parse_nifti_header(const std::filesystem::path& file,
                               std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes1) {
    refuse(file, "the file is too short for a NIfTI header", "at least 348 bytes",
           std::to_string(bytes.size()) + " bytes");
  }
  for (const bool swapped : {false, true}) {
    const Fields fields(bytes, swapped);
    const auto declared = fields.at<std::int32_t>(0);
    const bool version_2 = declared == kHeaderBytes2 && bytes.size() >= kHeaderBytes2;
    if (declared != kHeaderBytes1 && !version_2) continue;
    NiftiHeader header = version_2 ? parse_version_2(file, fields) : parse_version_1(file, fields);
    header.swapped = swapped;
    require_dimensions(file, header);
    return header;
  }
  refuse(file, "not a NIfTI header", "a header size of 348 or 540",
         std::to_string(Fields(bytes, false).at<std::int32_t>(0)));
}

NiftiAffine nifti_affine(const std::filesystem::path& file, const NiftiHeader& header) {
  NiftiAffine affine = affine_as_stored(file, header);
  if (!is_usable(affine)) {
    refuse(file, "the transform to patient space is not usable",
           "finite numbers and a spacing above 0 in sform or qform");
  }
  const double scale = millimetres_per_unit(header.length_unit);
  const glm::dvec3 ras_to_lps(-scale, -scale, scale);
  for (int axis = 0; axis < 3; ++axis) affine.steps_mm[axis] *= ras_to_lps;
  affine.origin_mm *= ras_to_lps;
  return affine;
}

NiftiVoxelType nifti_voxel_type(const std::filesystem::path& file, const NiftiHeader& header) {
  switch (header.datatype) {
    case 2:
      return {Component::uint8, 1};
    case 4:
      return {Component::int16, 1};
    case 8:
      return {Component::int32, 1};
    case 16:
      return {Component::float32, 1};
    case 64:
      return {Component::float64, 1};
    case 128:
      return {Component::uint8, 3};
    case 256:
      return {Component::int8, 1};
    case 512:
      return {Component::uint16, 1};
    case 768:
      return {Component::uint32, 1};
    case 1024:
      return {Component::int64, 1};
    case 1280:
      return {Component::uint64, 1};
    case 2304:
      return {Component::uint8, 4};
    default:
      break;
  }
  refuse(file, "this NIfTI data type is not read",
         "8 to 64 bit integers, 32 or 64 bit floats, RGB or RGBA",
         "data type " + std::to_string(header.datatype));
}

}  // namespace cutaway::reading
