// Compressed pixels of one frame to plain ones: the door to GDCM.
#pragma once

#include <filesystem>
#include <string>

#include "import/dicom/transfer_syntax.h"

namespace cutaway::reading {

/// How stored values lie in bytes.
struct StoredBits {
  int allocated = 16;
  int stored = 16;
  int high_bit = 15;
  bool is_signed = false;
};

struct PackedFrame {
  std::filesystem::path file;
  std::string transfer_syntax;
  PixelPacking packing = PixelPacking::plain;
  int columns = 0;
  int rows = 0;
  StoredBits bits;
  std::string bytes;
};

struct PlainFrame {
  std::string bytes;  ///< little endian
  StoredBits bits;    ///< a codec may give 8 bits where the header promised 16
};

/// What the compressed picture says of its own size is held against the header's before anything
/// is decoded. Throws Error naming the file where they disagree, or the picture is broken.
PlainFrame unpacked(PackedFrame frame);

}  // namespace cutaway::reading
