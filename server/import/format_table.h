// The formats that are read, one row each. A new reader is its file, a row, CMake and the README.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "import/formats.h"

namespace cutaway::reading {

struct Format {
  std::string_view name;                                ///< as in VolumeDescription::format
  std::span<const std::string_view> endings;            ///< of file names, in lower case
  bool (*has_mark)(const std::filesystem::path& file);  ///< by its first bytes, whatever its name;
                                                        ///< null where the format has no mark

  /// What files of the format (canonical paths) hold; opens each by context.look_into(). What is
  /// broken goes to `refused`. Throws Cancelled alone.
  Listing (*find)(std::span<const std::filesystem::path> files, const ScanContext& context);

  /// Reads what `find` found; the files are looked at anew, for they may have changed since. Throws
  /// Error.
  RawVolume (*read)(const VolumeSource& source, const ReadContext& context);
};

std::span<const Format> format_table();

/// By its name's ending, else by a mark; null for neither. Opens a file without a known ending.
const Format* format_of(const std::filesystem::path& file);

/// Null for a name of none.
const Format* format_named(std::string_view name);

/// "DICOM, NIfTI, ..."
std::string formats_in_words();

}  // namespace cutaway::reading
