#include "load/script.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "load/script_error.h"

namespace cutaway::load {
namespace {

namespace fs = std::filesystem;

Json small() {
  return Json::parse(R"({
    "title": "t", "volume": "phantom:head@32", "style": "flagship",
    "roles": [{"name": "r", "viewport": {"width_px": 64, "height_px": 48},
               "motion": [{"for_s": 1, "motion": {"orbit": {"degrees_per_second": 30}}}]}]})");
}

ScriptError::Detail refusal(const std::string& text) {
  try {
    parse_script(text);
  } catch (const ScriptError& error) {
    return error.detail();
  }
  return {};
}

/// What the small script is refused for once this merge patch is applied to its first role.
ScriptError::Detail refused_role(const char* patch) {
  Json script = small();
  script["roles"][0].merge_patch(Json::parse(patch));
  return refusal(script.dump());
}

ScriptError::Detail refused(const char* patch) {
  Json script = small();
  script.merge_patch(Json::parse(patch));
  return refusal(script.dump());
}

TEST(Script, IsReadWithItsDefaults) {
  const Script script = parse_script(small().dump());
  EXPECT_EQ(script.clients, 1);
  EXPECT_EQ(script.seconds, 30.0);
  ASSERT_EQ(script.roles.size(), 1U);
  const Role& role = script.roles[0];
  EXPECT_EQ(role.inputs_per_second, 60.0);
  EXPECT_EQ(role.link.bytes_per_second, 0);
  EXPECT_TRUE(role.judged());
  EXPECT_EQ(std::get<Orbit>(role.motion[0].motion).degrees_per_second, 30.0);
  EXPECT_EQ(script.thresholds.errors, 0);
  EXPECT_FALSE(script.thresholds.latency_p95_ms);
}

TEST(Script, ErrorsNameTheFieldWhatWasExpectedAndWhatCame) {
  const auto viewport = refused_role(R"({"viewport": {"width_px": 9000}})");
  EXPECT_EQ(viewport.field, "/roles/0/viewport/width_px");
  EXPECT_EQ(viewport.expected, "a whole number, 1 to 8192 px");
  EXPECT_EQ(viewport.received, "9000");
  EXPECT_EQ(viewport.code, "out-of-range");
}

TEST(Script, ErrorsTellTypesNamesAndMissingFieldsApart) {
  EXPECT_EQ(refused(R"({"volume": 7})").code, "wrong-type");
  EXPECT_EQ(refused(R"({"volume": null})").code, "missing-field");
  EXPECT_EQ(refused(R"({"volume": null})").field, "/volume");
  EXPECT_EQ(refused(R"({"volumes": 7})").code, "unknown-field");
  EXPECT_EQ(refused(R"({"volumes": 7})").field, "/volumes");
  EXPECT_EQ(refused(R"({"version": 2})").expected, "1");
  EXPECT_EQ(refused(R"({"clients": 1.5})").code, "wrong-type");
  EXPECT_EQ(refused(R"({"roles": []})").expected, "a list of 1 to 32 entries");
  EXPECT_EQ(refused(R"({"thresholds": {"fairness": "20 %"}})").expected, "a number, 0 to 1");
}

TEST(Script, ErrorsDeepInsideNameTheDeepestField) {
  const auto motion = refused_role(
      R"({"motion": [{"for_s": 1, "motion": {"orbit": {"degrees_per_second": "fast"}}}]})");
  EXPECT_EQ(motion.field, "/roles/0/motion/0/motion/orbit/degrees_per_second");
  const auto kind = refused_role(R"({"motion": [{"for_s": 1, "motion": {"spin": {}}}]})");
  EXPECT_EQ(kind.field, "/roles/0/motion/0/motion/spin");
  EXPECT_EQ(kind.expected, "exactly one of drag_lens, idle, inspect, orbit, recorded, zoom");
  const auto two =
      refused_role(R"({"motion": [{"for_s": 1, "motion": {"idle": {}, "zoom": {}}}]})");
  EXPECT_EQ(two.field, "/roles/0/motion/0/motion");
  const auto message = refused_role(
      R"({"motion": [{"for_s": 1, "motion": {"recorded": [{"at_s": 0, "message": {"type": "ack"}}]}}]})");
  EXPECT_EQ(message.field, "/roles/0/motion/0/motion/recorded/0/message/type");
  EXPECT_EQ(message.expected, "one of scene, viewport, drag_lens");
}

TEST(Script, RefusesWhatNoSchemaCanSay) {
  EXPECT_EQ(refused_role(R"({"motion": [{"for_s": 1, "think_s": [2, 1], "motion": {"idle": {}}}]})")
                .field,
            "/roles/0/motion/0/think_s");
  Json script = small();
  script["roles"].push_back(script["roles"][0]);
  EXPECT_EQ(refusal(script.dump()).field, "/roles/1/name");
}

TEST(Script, ErrorsOfBrokenTextAreInWords) {
  EXPECT_EQ(refusal("{").code, "malformed-json");
  EXPECT_EQ(refusal("[]").code, "wrong-type");
  EXPECT_THROW(read_script("/nowhere.json"), std::runtime_error);
  EXPECT_LT(refused(("{\"volume\": [\"" + std::string(9000, 'x') + "\"]}").c_str()).received.size(),
            100U);
}

std::string text_of_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The load script's fixtures of protocol/; the server's own tests leave them out.
std::vector<fs::path> script_fixtures(const char* folder) {
  std::vector<fs::path> paths;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CUTAWAY_SOURCE_DIR) / "protocol/fixtures" / folder)) {
    if (entry.path().stem().string().starts_with("load-script-")) paths.push_back(entry.path());
  }
  return paths;
}

TEST(Script, ValidFixturesAreAccepted) {
  EXPECT_FALSE(script_fixtures("valid").empty());
  for (const fs::path& path : script_fixtures("valid"))
    EXPECT_NO_THROW(parse_script(text_of_file(path))) << path;
}

TEST(Script, InvalidFixturesAreRefusedWithCodeAndField) {
  EXPECT_FALSE(script_fixtures("invalid").empty());
  for (const fs::path& path : script_fixtures("invalid")) {
    const Json fixture = Json::parse(text_of_file(path));
    const auto detail = refusal(fixture.at("document").dump());
    EXPECT_EQ(detail.code, fixture.at("error").at("code").get<std::string>()) << path;
    EXPECT_EQ(detail.field, fixture.at("error").at("field").get<std::string>()) << path;
  }
}

TEST(Script, ShippedScriptsOfTodayAndOfOldAreAccepted) {
  for (const char* folder : {"tests/load/scripts", "tests/golden/load_scripts"}) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(CUTAWAY_SOURCE_DIR) / folder)) {
      EXPECT_FALSE(read_script(entry.path()).description.empty()) << entry.path();
      ++count;
    }
    EXPECT_EQ(count, 5) << folder;
  }
}

TEST(Roles, AreAssignedByTheirShares) {
  const std::vector<Role> roles = {
      {.name = "many", .share = 28}, {.name = "one", .share = 1}, {.name = "two", .share = 1}};
  const std::vector<int> assigned = assign_roles(roles, 30);
  EXPECT_EQ(std::ranges::count(assigned, 0), 28);
  EXPECT_EQ(std::ranges::count(assigned, 1), 1);
  EXPECT_EQ(std::ranges::count(assigned, 2), 1);
  EXPECT_EQ(assign_roles(roles, 1), std::vector<int>{0});
}

}  // namespace
}  // namespace cutaway::load
