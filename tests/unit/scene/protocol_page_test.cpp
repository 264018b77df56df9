// What protocol/README.md lists of a schema is all that stands there.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/error_code.h"

namespace cutaway {
namespace {

std::string protocol_page() {
  std::ifstream file(CUTAWAY_SOURCE_DIR "/protocol/README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What stands in backticks from `heading` to the end of its sentence.
std::vector<std::string> words_after(const std::string& page, const std::string& heading) {
  std::vector<std::string> words;
  std::size_t at = page.find(heading);
  if (at == std::string::npos) return words;
  const std::size_t end = page.find("`. ", at);
  while ((at = page.find('`', at)) < end) {
    const std::size_t close = page.find('`', at + 1);
    words.push_back(page.substr(at + 1, close - at - 1));
    at = close + 1;
  }
  return words;
}

TEST(ProtocolPage, NamesEachErrorCodeOfTheSchema) {
  EXPECT_EQ(words_after(protocol_page(), "Error codes: "),
            std::vector<std::string>(kErrorCodeWords.begin(), kErrorCodeWords.end()));
}

}  // namespace
}  // namespace cutaway
