// Stored pixel values out of a DICOM file, whatever its transfer syntax.
#pragma once

#include <vector>

#include "import/dicom/frame.h"

namespace cutaway::reading {

/// All frames of one file, decoded. Throws Error naming the file where they cannot be, or are not
/// what the header says.
class DicomPixels {
 public:
  DicomPixels(const DicomFrame& any_frame_of_file, std::size_t frames_in_file);

  /// Writes one frame to `voxels` from `first` on: stored values where `voxels` is of integers,
  /// slope and intercept applied where it is of floats. Marks what is padding in `padding`, which
  /// is as long as `voxels` where the frame declares any.
  void store(const DicomFrame& frame, std::size_t first, RawVoxels& voxels,
             PaddingMask& padding) const;

 private:
  std::filesystem::path file_;
  std::vector<char> bytes_;
  std::size_t frame_voxels_ = 0;
  Component component_ = Component::uint16;
  int bits_stored_ = 16;
  int high_bit_ = 15;
};

}  // namespace cutaway::reading
