#include "load/frame_header.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace cutaway::load {
namespace {

namespace fs = std::filesystem;
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

std::vector<fs::path> fixtures(const char* kind) {
  std::vector<fs::path> paths;
  const fs::path folder = fs::path(CUTAWAY_SOURCE_DIR) / "protocol/fixtures/frame_header" / kind;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".bin") paths.push_back(entry.path());
  return paths;
}

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(FrameHeader, IsReadAsTheProtocolsFixtures) {
  EXPECT_FALSE(fixtures("valid").empty());
  for (fs::path path : fixtures("valid")) {
    const FrameHeader header = parse_frame_header(content(path));
    const auto expected = nlohmann::json::parse(content(path.replace_extension(".json")));
    constexpr std::array kTypes{"", "live", "saved_still", "preview"};
    EXPECT_EQ(kTypes.at(static_cast<std::size_t>(header.type)), expected.at("type")) << path;
    EXPECT_EQ(header.still, expected.at("still")) << path;
    EXPECT_EQ(header.number, expected.at("frame")) << path;
    EXPECT_EQ(header.revision, expected.at("revision")) << path;
    EXPECT_EQ(header.input, expected.at("input")) << path;
    EXPECT_EQ(header.clock_ms, expected.at("clock_ms")) << path;
    EXPECT_EQ(header.render_us, expected.at("render_us")) << path;
    EXPECT_EQ(header.encode_us, expected.at("encode_us")) << path;
    EXPECT_EQ(header.width_px, expected.at("width_px")) << path;
    EXPECT_EQ(header.height_px, expected.at("height_px")) << path;
    EXPECT_EQ(header.picture_bytes, expected.at("picture").size()) << path;
  }
}

TEST(FrameHeader, RefusesTheProtocolsInvalidFixtures) {
  EXPECT_FALSE(fixtures("invalid").empty());
  for (const fs::path& path : fixtures("invalid"))
    EXPECT_FALSE(complaint(content(path)).empty()) << path;
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
