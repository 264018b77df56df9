#include "load/frame_header.h"

#include <bit>
#include <string>

namespace cutaway::load {

namespace {

constexpr std::uint32_t kMagic = 0x46575443;
constexpr std::size_t kHeaderBytes = 56;
constexpr unsigned kStillFlag = 1;

/// `Number` of that many bytes, little-endian, at an offset.
template <typename Number>
Number at(std::string_view message, std::size_t offset) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const auto byte = static_cast<unsigned char>(message[offset + i]);
    value |= std::uint64_t{byte} << (8 * i);
  }
  return static_cast<Number>(value);
}

void expect(bool holds, const std::string& what, const std::string& expected,
            std::uint64_t received) {
  if (holds) return;
  throw BrokenFrame(what + ": expected " + expected + "; came " + std::to_string(received));
}

void check_layout(std::string_view message) {
  expect(message.size() >= kHeaderBytes, "bytes of a binary message", "at least 56",
         message.size());
  expect(at<std::uint32_t>(message, 0) == kMagic, "magic of a binary message",
         std::to_string(kMagic), at<std::uint32_t>(message, 0));
  const auto header_bytes = at<std::uint16_t>(message, 8);
  expect(header_bytes >= kHeaderBytes, "header length", "at least 56", header_bytes);
  expect(at<std::uint8_t>(message, 4) >= 1, "header version", "at least 1",
         at<std::uint8_t>(message, 4));
  const auto type = at<std::uint8_t>(message, 5);
  expect(type >= 1 && type <= 3, "type of a binary message", "1 to 3", type);
  const std::size_t announced = std::size_t{header_bytes} + at<std::uint32_t>(message, 48);
  expect(message.size() == announced, "bytes of a binary message", std::to_string(announced),
         message.size());
}

}  // namespace

FrameHeader parse_frame_header(std::string_view message) {
  check_layout(message);
  return {.type = static_cast<FrameHeader::Type>(at<std::uint8_t>(message, 5)),
          .still = (at<std::uint8_t>(message, 6) & kStillFlag) != 0,
          .number = at<std::uint32_t>(message, 12),
          .revision = at<std::uint32_t>(message, 16),
          .input = at<std::uint32_t>(message, 20),
          .clock_ms = std::bit_cast<double>(at<std::uint64_t>(message, 24)),
          .render_us = at<std::uint32_t>(message, 32),
          .encode_us = at<std::uint32_t>(message, 36),
          .width_px = at<std::uint16_t>(message, 40),
          .height_px = at<std::uint16_t>(message, 42),
          .picture_bytes = at<std::uint32_t>(message, 48)};
}

}  // namespace cutaway::load
