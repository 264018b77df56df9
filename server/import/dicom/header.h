// The elements of a DICOM file that lie before its pixels: where each stands, and how it is
// written. Source: DICOM PS3.5, 7.1 to 7.5, A.1 to A.5; PS3.10, 7.1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "import/dicom/byte_source.h"

namespace cutaway::reading {

using DicomTag = std::uint32_t;  ///< group << 16 | element

struct DicomItem;

/// Values stay in the file: what is there of an element is its place.
struct DicomElement {
  DicomTag tag = 0;
  std::array<char, 2> vr{};  ///< zeros where the file does not say
  bool is_big_endian = false;
  std::uint32_t length = 0;
  std::uint64_t offset = 0;      ///< of the value
  std::vector<DicomItem> items;  ///< of a sequence
};

struct DicomItem {
  std::vector<DicomElement> elements;

  const DicomElement* find(DicomTag tag) const;
};

/// Pixel Data, Float Pixel Data or Double Float Pixel Data.
struct DicomPixelElement {
  DicomTag tag = 0;
  std::array<char, 2> vr{};
  std::uint64_t offset = 0;  ///< of the value; of the first item where it is in fragments
  std::uint64_t length = 0;  ///< 0 where it is in fragments
  bool is_in_fragments = false;
};

struct DicomHeader {
  std::string transfer_syntax;  ///< "" where the file does not say
  std::string storage_class;    ///< as group 0002 has it
  bool is_big_endian = false;
  bool is_partly_unpacked = false;  ///< deflated, and longer than was asked for
  DicomItem data;
  std::optional<DicomPixelElement> pixels;
};

/// Enough for any header. Pixels behind it want more.
inline constexpr std::uint64_t kMostUnpackedHeaderBytes = std::uint64_t{16} << 20;

/// Reads heads of elements and no values, so that memory follows the number of elements, of which
/// there is a limit. VRs that are wrong or absent, and bytes in implicit VR where the syntax says
/// explicit, are taken as they are; a deflated file is unpacked within `source`, up to
/// `most_unpacked_bytes`. Throws Error naming the file where it ends within an element, or where
/// what follows is none.
DicomHeader read_dicom_header(ByteSource& source,
                              std::uint64_t most_unpacked_bytes = kMostUnpackedHeaderBytes);

/// "DICM" behind a preamble, or, as old archives have it, a data set from the first byte on.
bool looks_like_dicom(const std::filesystem::path& file);

}  // namespace cutaway::reading
