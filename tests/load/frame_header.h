// The header of a binary message, as protocol/README.md lays it out; the load client's own reading
// of it.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace cutaway::load {

struct FrameHeader {
  enum class Type : std::uint8_t { live = 1, saved_still = 2, preview = 3 };

  Type type = Type::live;
  bool still = false;
  std::uint32_t number = 0;
  std::uint32_t revision = 0;
  std::uint32_t input = 0;
  double clock_ms = 0.0;  ///< the client's own, of that input
  std::uint32_t render_us = 0;
  std::uint32_t encode_us = 0;
  std::uint16_t width_px = 0;
  std::uint16_t height_px = 0;
  std::uint32_t picture_bytes = 0;
};

/// A binary message that does not follow the protocol.
class BrokenFrame : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws BrokenFrame, which says what was expected and what came.
FrameHeader parse_frame_header(std::string_view message);

}  // namespace cutaway::load
