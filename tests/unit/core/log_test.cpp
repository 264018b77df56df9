#include "core/log.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/printable.h"

namespace cutaway {
namespace {

TEST(Printable, WritesControlCharactersOut) {
  EXPECT_EQ(printable("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(printable(std::string("\0\x7f", 2)), "\\x00\\x7f");
  EXPECT_EQ(printable("\xc2\x9b 31m"), "\\x9b 31m");
}

TEST(Printable, LeavesEverythingElse) {
  for (const char* text : {"", "plain", "Schädel \xe2\x86\x92 \xc2\xa0\xc2", "back\\slash"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Log, AnEventIsOneLineWhateverItRepeats) {
  ::testing::internal::CaptureStderr();
  log().warn("{} was asked for", "x\n12:00:00.000 error all is lost\x1b[2J");
  const std::string line = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
  EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
  EXPECT_NE(line.find("x\\n12:00:00.000 error all is lost\\x1b[2J was asked for"),
            std::string::npos)
      << line;
}

}  // namespace
}  // namespace cutaway
