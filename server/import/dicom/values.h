// From stored pixel values to what they mean.
// Source: DICOM PS3.3, C.11.1 (modality LUT), C.7.6.16.2.9, C.7.6.16.2.11 (real world values).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/dicom/data_set.h"
#include "volume/volume.h"

namespace cutaway::reading {

/// A Modality LUT Sequence: values below the first and above the last entry mean what those do.
struct ValueTable {
  std::int32_t first_stored = 0;
  std::vector<std::uint16_t> entries;  ///< at least one

  double value_of(double stored) const;
  bool operator==(const ValueTable&) const = default;
};

/// By a table where there is one, else by slope and intercept.
struct ValueMeaning {
  double slope = 1.0;
  double intercept = 0.0;
  std::shared_ptr<const ValueTable> table;
  bool is_stated = false;      ///< else the values are as stored for want of anything else
  bool is_real_world = false;  ///< a mapping that the file's windows know nothing of
  std::string units = "none";

  /// Of the numbers: what the units are called may differ.
  bool operator==(const ValueMeaning& other) const;
};

/// What an image says of its values: at its top level, and in the functional groups of a frame.
/// `groups` are those data sets that may hold a rescale and a real world mapping, the nearest to
/// the frame first. Throws Error naming the file where a table is not usable.
ValueMeaning value_meaning(const std::filesystem::path& file, const DataSet& data,
                           const std::vector<DataSet>& groups, bool is_hounsfield_by_default);

/// The first of the windows that `groups` offer, in values of that meaning.
/// Source: DICOM PS3.3, C.11.2.1.2.
std::optional<ValueRange> window_of(const std::vector<DataSet>& groups,
                                    const ValueMeaning& meaning);

}  // namespace cutaway::reading
