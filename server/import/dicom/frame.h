// One image plane of a DICOM series, as its header describes it: from a file of its own or a frame
// of an enhanced one.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/dicom/padding.h"
#include "import/raw_voxels.h"

namespace cutaway::reading {

/// What may tell apart planes that lie at the same place. The first three always part a series; the
/// rest where they must.
enum class PlaneKey {
  echo_number,
  temporal_position,
  stack,
  echo_time,
  b_value,
  trigger_time,
  acquisition_number,
  image_type,
  acquisition_time,
  content_time,
};
inline constexpr std::size_t kPlaneKeys = 10;
inline constexpr std::size_t kPlaneKeysThatAlwaysPart = 3;

/// For a title: "echo", "acquisition time".
std::string_view name_of(PlaneKey key);

/// DICOM PS3.3 C.7.6.2 (image plane), C.7.6.16 (functional groups). LPS mm.
struct DicomFrame {
  std::filesystem::path file;
  int index = 0;  ///< frame within its file
  int frames_in_file = 1;
  std::string series_uid;
  std::string instance_uid;
  std::string modality;
  std::string title;  ///< series or study description; never the patient
  std::string rescale_type;
  bool is_localizer = false;
  bool low_is_bright = false;  ///< MONOCHROME1
  Component component = Component::uint16;
  glm::ivec2 size_px{0};       ///< columns, rows
  glm::dvec2 spacing_mm{0.0};  ///< between columns, between rows
  glm::dvec3 row_axis{0.0};    ///< towards higher columns
  glm::dvec3 column_axis{0.0};
  glm::dvec3 position_mm{0.0};
  double slope = 1.0;
  double intercept = 0.0;
  std::optional<PixelPadding> padding;
  std::optional<ValueRange> window;  ///< physical values
  std::array<std::string, kPlaneKeys> keys;
};

/// The planes of a file, none where it is DICOM but no image. Throws Error naming the file for one
/// that is broken, or an image whose planes are no part of a volume (colour, no position, bit
/// planes, mosaics). Reads no pixel.
std::vector<DicomFrame> read_dicom_frames(const std::filesystem::path& file);

/// "DICM" behind the preamble.
bool has_dicom_magic(const std::filesystem::path& file);

}  // namespace cutaway::reading
