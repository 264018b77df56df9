#include "scene/frame_header.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "core/error.h"

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

TEST(FrameHeader, HasTheBytesOfTheProtocol) {
  const std::array<std::uint8_t, kFrameHeaderBytes> by_hand{
      'C',  'T',  'W',  'F',                     // magic
      1,    1,    1,    0,                       // version, live frame, still quality, reserved
      56,   0,    0,    0,                       // header length, view
      0x01, 0x02, 0x03, 0x04,                    // frame
      7,    0,    0,    0,                       // revision
      0xFF, 0xFF, 0xFF, 0xFF,                    // input
      0,    0,    0,    0,    0, 0, 0xF0, 0x3F,  // 1.0
      0x45, 0x23, 0x01, 0,                       // render
      0x2C, 0x01, 0,    0,                       // encode
      0x00, 0x04, 0x00, 0x03,                    // picture
      0xCD, 0xAB, 1,    0,                       // viewport
      3,    0,    0,    0,                       // bytes
      0,    0,    0,    0};                      // reserved
  EXPECT_EQ(encode_frame_header(example()), by_hand);
}

TEST(FrameHeader, MarksAStill) {
  FrameHeader header = example();
  header.type = PictureType::saved_still;
  header.still_quality = false;
  header.lossless = true;
  EXPECT_EQ(encode_frame_header(header)[5], 2);
  EXPECT_EQ(encode_frame_header(header)[6], 2);
}

TEST(FrameHeader, IsReadBackWithItsPicture) {
  const auto message = message_of(example(), {9, 8, 7, 6});
  const DecodedFrame frame = decode_frame(message);
  EXPECT_EQ(frame.header, example());
  EXPECT_TRUE(std::ranges::equal(frame.picture, std::vector<std::uint8_t>{9, 8, 7}));
}

TEST(FrameHeader, OfALaterVersionIsReadAsFarAsKnown) {
  auto message = message_of(example(), {9, 8, 7});
  message[4] = 2;
  message[8] = 60;
  message.insert(message.begin() + 56, {1, 2, 3, 4});
  const DecodedFrame frame = decode_frame(message);
  EXPECT_EQ(frame.header, example());
  EXPECT_EQ(frame.picture.front(), 9);
}

TEST(FrameHeader, RefusesWhatIsNoFrame) {
  using Damage = std::function<void(std::vector<std::uint8_t>&)>;
  const Damage damages[] = {
      [](auto& m) { m.clear(); },   [](auto& m) { m.resize(55); }, [](auto& m) { m[0] = 'X'; },
      [](auto& m) { m[5] = 0; },    [](auto& m) { m[5] = 4; },     [](auto& m) { m[8] = 55; },
      [](auto& m) { m[9] = 0xFF; }, [](auto& m) { m.pop_back(); }, [](auto& m) { m[51] = 0xFF; },
  };
  for (const Damage& damage : damages) {
    auto message = message_of(example(), {9, 8, 7});
    damage(message);
    EXPECT_THROW(decode_frame(message), Error);
  }
}

}  // namespace
}  // namespace cutaway
