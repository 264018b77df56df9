#include "scene/frame_header.h"

#include <bit>
#include <string>

#include "core/error.h"

namespace cutaway {

namespace {

constexpr std::uint32_t kMagic = 0x46575443;  // "CTWF"
constexpr std::uint8_t kVersion = 1;
constexpr std::uint8_t kStillQuality = 1U << 0U;
constexpr std::uint8_t kLossless = 1U << 1U;
constexpr std::size_t kHeaderLengthOffset = 8;

/// Little-endian on any machine.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> bytes) : bytes_(bytes) {}

  template <typename T>
  Writer& put(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i)
      bytes_[position_++] = static_cast<std::uint8_t>(value >> (8U * i));
    return *this;
  }

 private:
  std::span<std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <typename T>
  T take() {
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = static_cast<T>(value | static_cast<T>(T{bytes_[position_++]} << (8U * i)));
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

[[noreturn]] void refuse(const char* message, std::string expected, std::string received) {
  throw Error({.code = ErrorCode::out_of_range,
               .message = message,
               .expected = std::move(expected),
               .received = std::move(received)});
}

FrameHeader read_fields(Reader& reader, std::uint8_t type, std::uint8_t flags) {
  FrameHeader header;
  reader.take<std::uint16_t>();  // the header's length
  header.view = reader.take<std::uint16_t>();
  header.type = static_cast<PictureType>(type);
  header.still_quality = (flags & kStillQuality) != 0;
  header.lossless = (flags & kLossless) != 0;
  header.frame = reader.take<std::uint32_t>();
  header.revision = reader.take<std::uint32_t>();
  header.input = reader.take<std::uint32_t>();
  header.clock_ms = std::bit_cast<double>(reader.take<std::uint64_t>());
  header.render_us = reader.take<std::uint32_t>();
  header.encode_us = reader.take<std::uint32_t>();
  header.picture_width_px = reader.take<std::uint16_t>();
  header.picture_height_px = reader.take<std::uint16_t>();
  header.viewport_width_px = reader.take<std::uint16_t>();
  header.viewport_height_px = reader.take<std::uint16_t>();
  header.picture_bytes = reader.take<std::uint32_t>();
  return header;
}

}  // namespace

std::array<std::uint8_t, kFrameHeaderBytes> encode_frame_header(const FrameHeader& header) {
  std::array<std::uint8_t, kFrameHeaderBytes> bytes{};
  const auto flags = static_cast<std::uint8_t>((header.still_quality ? kStillQuality : 0U) |
                                               (header.lossless ? kLossless : 0U));
  Writer writer(bytes);
  writer.put(kMagic).put(kVersion).put(static_cast<std::uint8_t>(header.type)).put(flags);
  writer.put(std::uint8_t{0}).put(static_cast<std::uint16_t>(kFrameHeaderBytes)).put(header.view);
  writer.put(header.frame).put(header.revision).put(header.input);
  writer.put(std::bit_cast<std::uint64_t>(header.clock_ms));
  writer.put(header.render_us).put(header.encode_us);
  writer.put(header.picture_width_px).put(header.picture_height_px);
  writer.put(header.viewport_width_px).put(header.viewport_height_px);
  writer.put(header.picture_bytes).put(std::uint32_t{0});
  return bytes;
}

DecodedFrame decode_frame(std::span<const std::uint8_t> message) {
  if (message.size() < kFrameHeaderBytes)
    refuse("the message is shorter than a frame header", "at least 56 bytes",
           std::to_string(message.size()) + " bytes");
  Reader reader(message);
  if (const auto magic = reader.take<std::uint32_t>(); magic != kMagic)
    refuse("not a frame", "magic 0x46575443", std::to_string(magic));
  reader.take<std::uint8_t>();  // a later version only adds fields at the end
  const auto type = reader.take<std::uint8_t>();
  const auto flags = reader.take<std::uint8_t>();
  reader.take<std::uint8_t>();
  const std::size_t length = Reader(message.subspan(kHeaderLengthOffset)).take<std::uint16_t>();
  if (type < 1 || type > 3) refuse("unknown picture type", "1, 2 or 3", std::to_string(type));
  if (length < kFrameHeaderBytes || length > message.size())
    refuse("wrong header length", "56 to the message's length", std::to_string(length));
  const FrameHeader header = read_fields(reader, type, flags);
  const auto rest = message.subspan(length);
  if (rest.size() < header.picture_bytes)
    refuse("the picture is cut short", std::to_string(header.picture_bytes) + " bytes",
           std::to_string(rest.size()) + " bytes");
  return {header, rest.first(header.picture_bytes)};
}

}  // namespace cutaway
