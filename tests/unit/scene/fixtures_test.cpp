#include "unit/scene/fixtures.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace cutaway {
namespace {

class Valid : public testing::TestWithParam<Fixture> {};
class Invalid : public testing::TestWithParam<Fixture> {};

TEST_P(Valid, IsAccepted) { EXPECT_NO_THROW(accept(GetParam().schema, GetParam().text)); }

TEST_P(Invalid, IsRefusedWithCodeAndField) {
  const Fixture& fixture = GetParam();
  try {
    accept(fixture.schema, fixture.text);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(code_word(error.detail().code), fixture.error.at("code").get<std::string>())
        << error.what();
    EXPECT_EQ(error.detail().field, fixture.error.at("field").get<std::string>()) << error.what();
    EXPECT_FALSE(error.detail().message.empty());
    EXPECT_FALSE(error.detail().expected.empty()) << error.what();
  }
}

std::string test_name(const testing::TestParamInfo<Fixture>& info) {
  std::string name = info.param.name;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Fixtures, Valid, testing::ValuesIn(valid_fixtures()), test_name);
INSTANTIATE_TEST_SUITE_P(Fixtures, Invalid, testing::ValuesIn(invalid_fixtures()), test_name);

}  // namespace

void PrintTo(const Fixture& fixture, std::ostream* stream) { *stream << fixture.name; }

}  // namespace cutaway
