// What a TIFF's ImageDescription says of its pages: which are depth, and which channels or times.
// Sources: ImageJ's TiffDecoder ("name=value" lines, planes in the order channel, slice, time);
// OME-TIFF specification, docs.openmicroscopy.org (DimensionOrder, TiffData); tifffile's "axes".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cutaway::reading {

struct PictureText {
  int planes = 0;    ///< that it speaks of, one a page; 0 where it says nothing of them
  int channels = 1;  ///< of pages, beside those of a pixel
  int times = 1;
  std::vector<int> slice_pages;      ///< of the first channel and time, in order of depth
  bool times_are_slices = false;     ///< it calls pages times that have no other depth
  bool planes_follow_first = false;  ///< one directory may stand for all of them (ImageJ)

  std::array<std::string, 3> units;               ///< along x, y, z; empty where they are not said
  std::array<std::optional<double>, 3> spacings;  ///< in those; of ImageJ that along z alone
};

/// Anything else gives an empty one. Any thread.
PictureText read_picture_text(std::string_view description);

}  // namespace cutaway::reading
