// Stored pixel values of a DICOM file to voxels.
#pragma once

#include "import/dicom/pixel_file.h"

namespace cutaway::reading {

/// Writes one frame to `voxels` from `first` on: stored values where `voxels` is of integers and
/// the frame has no table of values, else what they mean. Marks what is padding in `padding`,
/// which is as long as `voxels` where the frame declares any. Throws Error naming the file where
/// the frame cannot be decoded, or is not what the header says.
void store_frame(PixelFile& pixels, const DicomFrame& frame, std::size_t first, RawVoxels& voxels,
                 PaddingMask& padding);

}  // namespace cutaway::reading
