// The pages of a TIFF, by its chain of directories. libtiff goes along that chain from its start
// for each page anew, so that a look at every page of thousands would take minutes. Sources:
// TIFF 6.0, section 2; Big TIFF, bigtiff.org.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cutaway::reading {

struct TiffPages {
  int count = 0;                          ///< 0 where the file is no TIFF
  std::optional<int> first_that_differs;  ///< from page 0, in size or number type; from 0 on
};

/// Counts up to `most` + 1, which is also where a chain that runs in a circle ends.
TiffPages tiff_pages(const std::filesystem::path& file, int most);

/// Where the first page's pixels begin, if they lie there in one piece and are not compressed.
struct PlainPixels {
  std::uint64_t begin = 0;
  bool big_endian = false;
};
std::optional<PlainPixels> plain_pixels(const std::filesystem::path& file);

}  // namespace cutaway::reading
