// Stored values that stand for "no pixel here", as around a CT's round field of view.
// Source: DICOM PS3.3, C.7.5.1.1.2 "Pixel Padding Value and Pixel Padding Range Limit".
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "import/padding_mask.h"
#include "import/raw_voxels.h"

namespace cutaway::reading {

class DataSet;

/// Both ends belong to it; before any rescale.
struct PixelPadding {
  double lowest = 0.0;
  double highest = 0.0;

  bool contains(double stored) const { return stored >= lowest && stored <= highest; }
};

/// Nothing where the image declares none. `component` is what its pixels are of.
std::optional<PixelPadding> pixel_padding(const DataSet& data, Component component);

/// Gives the padding the smallest real value among the other voxels, so that it does not widen the
/// value range; returns how many there were. A negative slope makes the largest number the smallest
/// value. Throws Error naming `file` where all of the volume is padding.
std::size_t replace_padding(const std::filesystem::path& file, const PaddingMask& padding,
                            double slope, RawVoxels& voxels);

}  // namespace cutaway::reading
