// One image plane of a DICOM series, as its header describes it: from a file of its own or a frame
// of an enhanced one.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/dicom/padding.h"
#include "import/dicom/values.h"
#include "import/raw_voxels.h"

namespace cutaway::reading {

/// Who and what a plane belongs to: planes that differ here are never one volume.
enum class Identity {
  patient_id,
  patient_name,
  study,
  series,
  series_number,
  frame_of_reference,
  modality,
  role,  ///< a localizer, or not
  kernel,
};
inline constexpr std::size_t kIdentities = 9;

/// What may tell apart planes that lie at the same place. The first three always part a series; the
/// rest where they must.
enum class PlaneKey {
  echo_number,
  temporal_position,
  stack,
  echo_time,
  b_value,
  inversion_time,
  trigger_time,
  cardiac_phase,
  acquisition_number,
  image_type,
  description,
  tube_voltage,
  flip_angle,
  gradient_direction,
  acquisition_time,
  content_time,
};
inline constexpr std::size_t kPlaneKeys = 16;
inline constexpr std::size_t kPlaneKeysThatAlwaysPart = 3;

/// For a title: "echo", "acquisition time".
std::string_view name_of(PlaneKey key);

/// What runs on from plane to plane, so that the planes at one place have an order.
enum class Moment { acquisition, trigger, content, instance };
inline constexpr std::size_t kMoments = 4;

/// What holds for all planes of a file.
struct DicomImage {
  std::filesystem::path file;
  int frames = 1;
  std::array<std::string, kIdentities> identity;
  std::string transfer_syntax;
  std::string title;           ///< series or study description; never the patient
  bool low_is_bright = false;  ///< MONOCHROME1
  Component component = Component::uint16;
  glm::ivec2 size_px{0};  ///< columns, rows
  std::optional<PixelPadding> padding;

  const std::string& of(Identity which) const {
    return identity.at(static_cast<std::size_t>(which));
  }
  bool is_localizer() const { return of(Identity::role) == "localizer"; }
};

/// DICOM PS3.3 C.7.6.2 (image plane), C.7.6.16 (functional groups). LPS mm.
struct DicomFrame {
  std::shared_ptr<const DicomImage> image;
  int index = 0;               ///< within its file
  glm::dvec2 spacing_mm{0.0};  ///< between columns, between rows
  glm::dvec3 row_axis{0.0};    ///< towards higher columns
  glm::dvec3 column_axis{0.0};
  glm::dvec3 position_mm{0.0};
  double position_error_mm = 0.0;  ///< by the digits that the file gives
  double axis_error = 0.0;         ///< likewise, of each cosine
  double thickness_mm = 0.0;       ///< 0 where the file does not say
  ValueMeaning meaning;
  std::optional<ValueRange> window;  ///< physical values
  std::array<std::string, kPlaneKeys> keys;
  std::array<std::optional<double>, kMoments> moments;

  const std::string& key(PlaneKey which) const { return keys.at(static_cast<std::size_t>(which)); }
  glm::dvec3 normal() const { return glm::cross(row_axis, column_axis); }
};

/// The planes of a file. Throws Error naming the file for one that is broken, an object that is no
/// image (by its name), an image whose planes are no part of a volume (colour, no position, bit
/// planes, mosaics), or one whose transfer syntax is not read. Reads no pixel.
std::vector<DicomFrame> read_dicom_frames(const std::filesystem::path& file);

}  // namespace cutaway::reading
