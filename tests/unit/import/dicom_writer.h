// DICOM files for tests, element by element.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cutaway::test {

using DicomTag = std::pair<std::uint16_t, std::uint16_t>;

/// 16 bits, as SS or US.
struct DicomShort {
  DicomTag tag;
  int value = 0;
  bool is_signed = false;
};

/// A Modality LUT Sequence.
struct DicomTable {
  int first_stored = 0;
  std::vector<std::uint16_t> entries;
  std::string type;
};

/// A linear Real World Value Mapping; none where the slope is 0.
struct DicomMapping {
  double slope = 0.0;
  double intercept = 0.0;
  std::string unit;
};

struct DicomSlice {
  std::string series_uid = "1.2.826.1";
  std::string modality = "CT";
  glm::ivec2 size_px{4, 4};
  glm::dvec2 spacing_mm{1.0};  ///< between columns, between rows
  glm::dvec3 row_axis{1, 0, 0};
  glm::dvec3 column_axis{0, 1, 0};
  glm::dvec3 position_mm{0.0};
  double slope = 1.0;
  double intercept = 0.0;
  int bits_stored = 16;
  bool is_signed = true;
  std::vector<std::int16_t> stored;  ///< as many as size_px says
  std::vector<float> floats;         ///< in their place: Float Pixel Data
  std::vector<double> doubles;       ///< likewise: Double Float Pixel Data
  DicomTable table;                  ///< where it has entries, in place of a rescale
  DicomMapping mapping;
  bool has_rescale = true;
  std::string storage_class;  ///< "": that of a CT image
  std::map<DicomTag, std::string>
      texts;  ///< further elements of text, or in place of those above; empty: leave it out

  std::vector<DicomShort> shorts;       ///< further elements of numbers
  std::map<DicomTag, std::string> vrs;  ///< that the texts are given instead of the dictionary's

  /// Stored values such that the rescaled ones are patient_ramp() at each pixel.
  void fill_with_ramp();
};

/// Explicit VR little endian. The instance UID is made from the file's name unless `texts` has one.
void write_dicom(const std::filesystem::path& file, const DicomSlice& slice);

enum class Syntax {
  explicit_little,
  implicit,
  big_endian,
  deflated,
  rle,
  jpeg_lossless,
  jpeg_ls,
  jpeg_2000
};

/// Takes preamble, mark and group 0002 away, as old archives never had them.
void strip_file_header(const std::filesystem::path& file);

/// Writes another transfer syntax into the header and leaves all else as it is.
void rename_syntax(const std::filesystem::path& file, const std::string& uid);

/// Rewrites a file; fails the test where GDCM cannot.
void transcode(const std::filesystem::path& file, Syntax syntax);

/// One enhanced multi-frame file; what frames share of orientation and spacing goes to the shared
/// groups, and the rescale, where `rescale_is_common`, to the top level. `temporal_positions` gives
/// each frame its TemporalPositionIndex.
void write_enhanced_dicom(const std::filesystem::path& file, const std::vector<DicomSlice>& frames,
                          const std::vector<std::uint32_t>& temporal_positions = {},
                          bool rescale_is_common = false);

/// `count` slices of a ramp, `step` apart, whose instance numbers run against their places.
std::vector<DicomSlice> ramp_series(int count, glm::dvec3 first, glm::dvec3 step,
                                    const DicomSlice& like = {});

/// A 7 x 5 slice of uneven spacing and rescale in that plane; `column` is made square to `row`.
DicomSlice ramp_slice(glm::dvec3 row, glm::dvec3 column);

std::vector<DicomSlice> with_text(std::vector<DicomSlice> slices, DicomTag tag,
                                  const std::string& text);

/// A file a slice, in an order of names that is not that of the places.
void write_series(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices,
                  const std::string& prefix = "");

}  // namespace cutaway::test
