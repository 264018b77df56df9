// How one element begins: tag, value representation, length.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cutaway::reading {

/// How the elements of a part of the file are written.
struct DicomEncoding {
  bool has_vr = true;
  bool is_big_endian = false;
};

inline constexpr std::uint32_t kUndefinedLength = 0xFFFFFFFF;
inline constexpr std::uint32_t kItem = 0xFFFEE000;
inline constexpr std::uint32_t kItemEnd = 0xFFFEE00D;
inline constexpr std::uint32_t kSequenceEnd = 0xFFFEE0DD;
inline constexpr std::uint64_t kShortHead = 8;
inline constexpr std::uint64_t kLongHead = 12;

struct ElementHead {
  std::uint32_t tag = 0;
  std::array<char, 2> vr{};  ///< zeros where there is none
  std::uint64_t bytes = kShortHead;
  std::uint32_t length = 0;

  bool is_open() const { return length == kUndefinedLength; }
  bool has_vr(std::string_view name) const { return std::string_view(vr.data(), 2) == name; }
  bool is_delimiter() const { return tag >> 16 == 0xFFFE; }
};

std::uint32_t number_of_bytes(std::string_view bytes, bool is_big_endian);

/// One of DICOM's.
bool is_known_vr(std::string_view vr);

/// The head at the front of kLongHead bytes. Where `encoding` promises a VR and none stands there,
/// the element is taken for one without; and the other way round, where its length would lead
/// beyond `bytes_left`.
ElementHead element_head(std::string_view front, const DicomEncoding& encoding,
                         std::uint64_t bytes_left);

}  // namespace cutaway::reading
