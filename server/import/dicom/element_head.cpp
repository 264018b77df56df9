#include "import/dicom/element_head.h"

namespace cutaway::reading {

namespace {

constexpr std::string_view kLongHeadVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
constexpr std::string_view kShortHeadVrs =
    "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";

bool is_one_of(std::string_view vrs, std::string_view vr) {
  const std::size_t place = vrs.find(vr);
  return place != std::string_view::npos && place % 3 == 0 && vr.find(' ') == vr.npos;
}

bool is_upper_case(std::string_view text) {
  return text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == text.npos;
}

/// VRs of later editions have the long form. Source: DICOM PS3.5, 6.2.2.
bool is_long(std::string_view vr) {
  return is_one_of(kLongHeadVrs, vr) || !is_one_of(kShortHeadVrs, vr);
}

}  // namespace

std::uint32_t number_of_bytes(std::string_view bytes, bool is_big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t next = is_big_endian ? i : bytes.size() - 1 - i;
    number = number << 8 | static_cast<unsigned char>(bytes[next]);
  }
  return number;
}

bool is_known_vr(std::string_view vr) {
  return is_one_of(kLongHeadVrs, vr) || is_one_of(kShortHeadVrs, vr);
}

ElementHead element_head(std::string_view front, const DicomEncoding& encoding,
                         std::uint64_t bytes_left) {
  const auto number = [&](std::size_t first, std::size_t bytes) {
    return number_of_bytes(front.substr(first, bytes), encoding.is_big_endian);
  };
  ElementHead head{.tag = number(0, 2) << 16 | number(2, 2), .length = number(4, 4)};
  if (head.is_delimiter()) return head;
  const std::string_view vr = front.substr(4, 2);
  const bool fits_without = head.is_open() || head.length <= bytes_left - kShortHead;
  const bool has_vr = encoding.has_vr ? is_upper_case(vr) : !fits_without && is_known_vr(vr);
  if (!has_vr) return head;
  head.vr = {vr[0], vr[1]};
  head.bytes = is_long(vr) ? kLongHead : kShortHead;
  head.length = is_long(vr) ? number(8, 4) : number(6, 2);
  return head;
}

}  // namespace cutaway::reading
