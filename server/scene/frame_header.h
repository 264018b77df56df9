// The header in front of a picture in a binary message; protocol/README.md has the layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cutaway {

enum class PictureType : std::uint8_t { live_frame = 1, saved_still = 2, preview = 3 };

struct FrameHeader {
  PictureType type = PictureType::live_frame;
  bool still_quality = false;
  bool lossless = false;
  std::uint16_t view = 0;
  std::uint32_t frame = 0;  ///< for a saved still or a preview the request
  std::uint32_t revision = 0;
  std::uint32_t input = 0;
  double clock_ms = 0.0;
  std::uint32_t render_us = 0;
  std::uint32_t encode_us = 0;
  std::uint16_t picture_width_px = 0;
  std::uint16_t picture_height_px = 0;
  std::uint16_t viewport_width_px = 0;
  std::uint16_t viewport_height_px = 0;
  std::uint32_t picture_bytes = 0;
  bool operator==(const FrameHeader&) const = default;
};

inline constexpr std::size_t kFrameHeaderBytes = 56;

std::array<std::uint8_t, kFrameHeaderBytes> encode_frame_header(const FrameHeader& header);

struct DecodedFrame {
  FrameHeader header;
  std::span<const std::uint8_t> picture;  ///< inside of the message
};

/// Reads a whole binary message, newer headers that are longer included. Throws Error for another
/// magic, a header that is too short, an unknown type, and a picture that is shorter than
/// announced.
DecodedFrame decode_frame(std::span<const std::uint8_t> message);

}  // namespace cutaway
