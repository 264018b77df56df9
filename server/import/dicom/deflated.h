// The data set of a deflated file. Source: DICOM PS3.5, A.5; RFC 1951.
#pragma once

#include <string>

#include "import/dicom/byte_source.h"

namespace cutaway::reading {

struct Unpacked {
  std::string bytes;
  bool is_partial = false;  ///< there were more than were asked for
};

/// From `offset` to the end of the file. Throws Error naming the file where it is broken.
Unpacked unpack_deflated(ByteSource& source, std::uint64_t offset, std::uint64_t most_bytes);

}  // namespace cutaway::reading
