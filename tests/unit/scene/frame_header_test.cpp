#include "scene/frame_header.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.h"
#include "unit/scene/fixtures.h"

namespace cutaway {
namespace {

FrameHeader example() {
  return {.type = PictureType::live_frame,
          .still_quality = true,
          .lossless = false,
          .frame = 0x04030201,
          .revision = 7,
          .input = 0xFFFFFFFF,
          .clock_ms = 1.0,
          .render_us = 0x00012345,
          .encode_us = 300,
          .picture_width_px = 1024,
          .picture_height_px = 768,
          .viewport_width_px = 0xABCD,
          .viewport_height_px = 1,
          .picture_bytes = 3};
}

std::vector<std::uint8_t> message_of(const FrameHeader& header,
                                     const std::vector<std::uint8_t>& picture) {
  const auto bytes = encode_frame_header(header);
  std::vector<std::uint8_t> message(bytes.begin(), bytes.end());
  message.insert(message.end(), picture.begin(), picture.end());
  return message;
}

/// As the fixtures' JSON has it.
Json described(const DecodedFrame& frame) {
  const FrameHeader& header = frame.header;
  constexpr std::array kTypes{"", "live", "saved_still", "preview"};
  return {{"type", kTypes.at(static_cast<std::size_t>(header.type))},
          {"still", header.still_quality},
          {"lossless", header.lossless},
          {"view", header.view},
          {"frame", header.frame},
          {"revision", header.revision},
          {"input", header.input},
          {"clock_ms", header.clock_ms},
          {"render_us", header.render_us},
          {"encode_us", header.encode_us},
          {"width_px", header.picture_width_px},
          {"height_px", header.picture_height_px},
          {"viewport_width_px", header.viewport_width_px},
          {"viewport_height_px", header.viewport_height_px},
          {"picture", std::vector<std::uint8_t>(frame.picture.begin(), frame.picture.end())}};
}

TEST(FrameHeader, IsReadAndWrittenAsTheProtocolsFixtures) {
  const auto fixtures = binary_fixtures("frame_header/valid");
  EXPECT_EQ(fixtures.size(), json_fixtures("frame_header/valid").size());
  for (const auto& [name, expected] : json_fixtures("frame_header/valid")) {
    const auto& message = fixtures.at(name);
    const DecodedFrame frame = decode_frame(message);
    EXPECT_EQ(described(frame), expected) << name;
    if (message.size() != kFrameHeaderBytes + frame.picture.size()) continue;  // a longer header
    EXPECT_EQ(message_of(frame.header, {frame.picture.begin(), frame.picture.end()}), message)
        << name;
  }
}

TEST(FrameHeader, RefusesTheProtocolsInvalidFixtures) {
  const auto fixtures = binary_fixtures("frame_header/invalid");
  EXPECT_FALSE(fixtures.empty());
  for (const auto& [name, message] : fixtures) EXPECT_THROW(decode_frame(message), Error) << name;
}

TEST(FrameHeader, IsReadBackWithItsPicture) {
  const auto message = message_of(example(), {9, 8, 7, 6});
  const DecodedFrame frame = decode_frame(message);
  EXPECT_EQ(frame.header, example());
  EXPECT_TRUE(std::ranges::equal(frame.picture, std::vector<std::uint8_t>{9, 8, 7}));
}

}  // namespace
}  // namespace cutaway
