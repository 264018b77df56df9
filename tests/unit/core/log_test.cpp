#include "core/log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

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

/// Standard error as a pipe that is full.
class FullStandardError {
 public:
  FullStandardError() : saved_(dup(STDERR_FILENO)) {
    EXPECT_EQ(pipe(ends_.data()), 0);
    dup2(ends_[1], STDERR_FILENO);
    fcntl(ends_[1], F_SETFL, O_NONBLOCK);
    const std::string block(4096, '.');
    while (write(ends_[1], block.data(), block.size()) > 0) {
    }
    fcntl(ends_[1], F_SETFL, 0);
  }
  ~FullStandardError() {
    dup2(saved_, STDERR_FILENO);
    for (const int each : {saved_, ends_[0], ends_[1]}) close(each);
  }
  FullStandardError(const FullStandardError&) = delete;
  FullStandardError& operator=(const FullStandardError&) = delete;

  std::string drained() {
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
    std::string all;
    std::array<char, 65536> piece{};
    for (ssize_t got = 0; (got = read(ends_[0], piece.data(), piece.size())) > 0;)
      all.append(piece.data(), static_cast<std::size_t>(got));
    return all;
  }

 private:
  int saved_;
  std::array<int, 2> ends_{};
};

TEST(Log, AReaderThatHasStoppedHoldsNobodyUp) {
  FullStandardError error;
  log().warn("one");
  log().warn("two");
  EXPECT_EQ(error.drained().find("one"), std::string::npos);
  log().warn("three");
  log().warn("four");
  const std::string lines = error.drained();
  EXPECT_NE(lines.find("warning 2 lines were left out"), std::string::npos) << lines;
  EXPECT_NE(lines.find("warning three\n"), std::string::npos) << lines;
  EXPECT_EQ(lines.find("left out"), lines.rfind("left out")) << lines;
}

}  // namespace
}  // namespace cutaway
