#include "scene/json_text.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace cutaway {
namespace {

Error::Detail refusal(const std::string& text) {
  try {
    parse_json(text);
  } catch (const Error& error) {
    return error.detail();
  }
  return {};
}

TEST(JsonText, ReadsDocuments) {
  const char* text = R"({"a": [1, -2.5, true, null, {"b": "\u00fc"}], "": {}})";
  EXPECT_EQ(parse_json(text), Json::parse(text));
  EXPECT_EQ(parse_json("5"), Json(5));
}

TEST(JsonText, TakesWholeNumbersForIntegersHoweverWritten) {
  EXPECT_TRUE(parse_json("2.0").is_number_integer());
  EXPECT_TRUE(parse_json("1e3").is_number_integer());
  EXPECT_TRUE(parse_json("2.5").is_number_float());
  EXPECT_EQ(parse_json("1e300"), Json(1e300));
}

TEST(JsonText, SaysWhereItStopped) {
  const Error::Detail detail = refusal(R"({"a": tru})");
  EXPECT_EQ(detail.code, ErrorCode::malformed_json);
  EXPECT_NE(detail.message.find("byte 10"), std::string::npos) << detail.message;
}

TEST(JsonText, NamesTheFieldOfANumberThatIsTooLarge) {
  EXPECT_EQ(refusal(R"({"a": [{"b": 1}, {"c": [0, [], 1e999]}]})").field, "/a/1/c/2");
  EXPECT_EQ(refusal(R"([[1], [2, 1e999]])").field, "/1/1");
  EXPECT_EQ(refusal("-1e999").code, ErrorCode::not_finite);
  EXPECT_EQ(refusal("-1e999").received, "'-1e999'");
}

TEST(JsonText, CanBeReadDespiteNumbersThatAreTooLarge) {
  const auto held = [](const char* text) { return parse_json(with_numbers_held(text)); };
  EXPECT_EQ(held(R"({"a": [1e999, -1e999, 2.5], "b": 1E+400})"),
            Json({{"a", {0, 0, 2.5}}, {"b", 0}}));
  EXPECT_EQ(held(R"({"1e999": "\"1e999"})"), Json({{"1e999", "\"1e999"}}));
  EXPECT_EQ(held((std::string(400, '9')).c_str()), Json(0));
  for (const char* cut_short : {"", "\"", "\"\\", "1e999", "[1e99"})
    EXPECT_NO_THROW(with_numbers_held(cut_short)) << cut_short;
}

TEST(JsonText, RefusesDeepNestingWithoutRecursion) {
  for (const char* opening : {"[", R"({"a":)", R"([{"a":)"}) {
    std::string text;
    while (text.size() < 65536) text += opening;
    EXPECT_EQ(refusal(text).code, ErrorCode::malformed_json);
  }
  EXPECT_NO_THROW(parse_json(std::string(32, '[') + std::string(32, ']')));
  EXPECT_EQ(refusal(std::string(33, '[') + std::string(33, ']')).expected, "at most 32 levels");
}

TEST(JsonText, RefusesBytesThatAreNotUtf8) {
  EXPECT_EQ(refusal("\"\xFF\"").code, ErrorCode::malformed_json);
  EXPECT_EQ(refusal(std::string("\"\0\"", 3)).code, ErrorCode::malformed_json);
}

TEST(JsonText, WritesTitlesThatAreNotUtf8) {
  EXPECT_EQ(json_text(Json{{"title", "M\xFCller"}}), "{\"title\":\"M\xEF\xBF\xBDller\"}");
}

TEST(JsonText, ShortensBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("a\xC3\xBC"
                      "b",
                      2),
            "a...");
}

TEST(JsonText, EscapesPointers) {
  EXPECT_EQ(pointer_to("/a", "b/c~d"), "/a/b~1c~0d");
  EXPECT_EQ(pointer_to("", std::size_t{3}), "/3");
}

}  // namespace
}  // namespace cutaway
