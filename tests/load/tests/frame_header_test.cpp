#include "load/frame_header.h"

#include <gtest/gtest.h>

#include <string>

namespace cutaway::load {
namespace {

using namespace std::string_literals;

/// A whole message, byte by byte as protocol/README.md has it, with a picture of 3 bytes.
std::string message() {
  return "CTWF\x01\x01\x01\x00"s              // magic, version 1, live, still quality
         "\x38\x00\x00\x00"s                  // header of 56 bytes, view 0
         "\x07\x00\x00\x00\x05\x00\x00\x00"s  // frame 7, revision 5
         "\xff\xff\xff\xff"s                  // input 2^32-1
         "\x00\x00\x00\x00\x00\x4a\x93\x40"s  // clock 1234.5 ms
         "\x10\x27\x00\x00\xe8\x03\x00\x00"s  // 10000 and 1000 us
         "\x40\x01\xf0\x00\x80\x02\xe0\x01"s  // 320x240 of 640x480
         "\x03\x00\x00\x00\x00\x00\x00\x00"s  // 3 bytes
         "abc"s;
}

std::string complaint(const std::string& text) {
  try {
    parse_frame_header(text);
  } catch (const BrokenFrame& broken) {
    return broken.what();
  }
  return {};
}

TEST(FrameHeader, IsReadAsTheProtocolHasIt) {
  const FrameHeader header = parse_frame_header(message());
  EXPECT_EQ(header.type, FrameHeader::Type::live);
  EXPECT_TRUE(header.still);
  EXPECT_EQ(header.number, 7U);
  EXPECT_EQ(header.revision, 5U);
  EXPECT_EQ(header.input, 0xffffffffU);
  EXPECT_EQ(header.clock_ms, 1234.5);
  EXPECT_EQ(header.render_us, 10000U);
  EXPECT_EQ(header.encode_us, 1000U);
  EXPECT_EQ(header.width_px, 320);
  EXPECT_EQ(header.height_px, 240);
  EXPECT_EQ(header.picture_bytes, 3U);
}

TEST(FrameHeader, MayHaveGrown) {
  std::string longer = message();
  longer[4] = 2;
  longer[8] = 60;
  longer.insert(56, 4, '\0');
  EXPECT_EQ(parse_frame_header(longer).number, 7U);
}

TEST(FrameHeader, IsRefusedWhenCutShortAnywhere) {
  const std::string whole = message();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(complaint(whole.substr(0, length)).empty()) << length;
  EXPECT_FALSE(complaint(whole + "d").empty());
}

TEST(FrameHeader, SaysWhatIsWrong) {
  std::string text = message();
  text[0] = 'X';
  EXPECT_NE(complaint(text).find("magic"), std::string::npos);
  text = message();
  text[5] = 9;
  EXPECT_EQ(complaint(text), "type of a binary message: expected 1 to 3; came 9");
  text = message();
  text[8] = 20;
  EXPECT_EQ(complaint(text), "header length: expected at least 56; came 20");
  text = message();
  text[4] = 0;
  EXPECT_NE(complaint(text).find("version"), std::string::npos);
}

}  // namespace
}  // namespace cutaway::load
