// What a compressed picture says of itself before it is decoded.
// Sources: ITU-T T.81 B.2.2 (JPEG), T.87 C.2.2 (JPEG-LS), T.800 A.5.1 (JPEG 2000).
#pragma once

#include <optional>
#include <string_view>

#include "import/dicom/transfer_syntax.h"

namespace cutaway::reading {

struct Codestream {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  int bits = 0;  ///< of a sample
  int samples = 0;
};

/// Nothing where its head is not found.
std::optional<Codestream> codestream_of(std::string_view bytes, PixelPacking packing);

/// Whether a picture begins here, rather than goes on from the fragment before.
bool begins_picture(std::string_view bytes, PixelPacking packing);

}  // namespace cutaway::reading
