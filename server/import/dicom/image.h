// What a DICOM file says of itself as a whole.
#pragma once

#include "import/dicom/data_set.h"
#include "import/dicom/frame.h"

namespace cutaway::reading {

/// Throws Error naming the file for an object that is no image, or an image that is no part of a
/// volume of grey values.
DicomImage dicom_image(const std::filesystem::path& file, const DicomHeader& header,
                       const DataSet& data);

/// Throws Error naming the file where it is shorter than its pixels, or has none.
void require_pixels(const DicomImage& image, const DicomHeader& header, const ByteSource& source);

}  // namespace cutaway::reading
