#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/resolve.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

Json complete() { return scene_document(resolve_scene(Json::object(), ball_facts(), {640, 480})); }

std::string refusal_field(const Json& base, const Json& patch) {
  try {
    patch_scene_document(base, patch);
  } catch (const Error& error) {
    return std::string(code_word(error.detail().code)) + " " + error.detail().field;
  }
  return "accepted";
}

TEST(Patch, ChangesWhatItNamesAndNothingElse) {
  const Json base = complete();
  const Json patched = patch_scene_document(base, {{"lens", {{"radius_mm", 12.5}}}});
  Json expected = base;
  expected["lens"]["radius_mm"] = 12.5;
  EXPECT_EQ(patched, expected);
}

TEST(Patch, NullOpensAFieldAgain) {
  const Json patched = patch_scene_document(
      complete(), Json::parse(R"({"camera": null, "lens": {"centre_mm": null}})"));
  EXPECT_FALSE(patched.contains("camera"));
  EXPECT_FALSE(patched.at("lens").contains("centre_mm"));
  EXPECT_TRUE(patched.at("lens").contains("radius_mm"));
}

TEST(Patch, ReplacesArraysWhole) {
  const Json patched = patch_scene_document(
      {{"focus", {{"filters", {{{"name", "sobel"}}, {{"name", "kuwahara"}}}}}}},
      Json::parse(R"({"focus": {"filters": [{"name": "kuwahara", "radius": 5}]}})"));
  EXPECT_EQ(patched.at("focus").at("filters"),
            Json::parse(R"([{"name": "kuwahara", "radius": 5}])"));
}

TEST(Patch, MergesTheParametersOfTheSameModule) {
  const Json base = Json::parse(R"({"focus": {"shading": {"name": "tone", "detail": 0.5}}})");
  const Json unnamed =
      patch_scene_document(base, Json::parse(R"({"focus": {"shading": {"terminator": 0.2}}})"));
  EXPECT_EQ(unnamed.at("focus").at("shading"),
            Json::parse(R"({"name": "tone", "detail": 0.5, "terminator": 0.2})"));
}

TEST(Patch, AnAliasChangesTheParameterThatItStandsFor) {
  const Json patched =
      patch_scene_document(complete(), Json::parse(R"({"focus": {"shading": {"ts": 0.1}}})"));
  EXPECT_DOUBLE_EQ(patched.at("focus").at("shading").at("detail").get<double>(), 0.2);
  EXPECT_FALSE(patched.at("focus").at("shading").contains("ts"));
  EXPECT_EQ(refusal_field(complete(), Json::parse(R"({"focus": {"shading": {"ts": 0.6}}})")),
            "out-of-range /focus/shading/ts");
}

TEST(Patch, ReplacesAModuleOfAnotherNameWhole) {
  const Json patched = patch_scene_document(
      complete(), Json::parse(R"({"focus": {"shading": {"name": "phong", "exponent": 5}}})"));
  EXPECT_EQ(patched.at("focus").at("shading"), Json::parse(R"({"name": "phong", "exponent": 5})"));
}

TEST(Patch, RefusesWithTheFieldAndLeavesTheBaseAlone) {
  const Json base = complete();
  const Json before = complete();
  EXPECT_EQ(refusal_field(base, {{"lens", {{"radius_mm", 1e9}}}}), "out-of-range /lens/radius_mm");
  EXPECT_EQ(refusal_field(base, {{"lens", 5}}), "wrong-type /lens");
  EXPECT_EQ(refusal_field(base, Json::array()), "wrong-type ");
  EXPECT_EQ(refusal_field(base, Json()), "wrong-type ");
  EXPECT_EQ(base, before);
}

TEST(Patch, RefusesUnknownFieldsThatAreNull) {
  EXPECT_EQ(refusal_field(complete(), Json::parse(R"({"zoom": null})")), "unknown-field /zoom");
  EXPECT_EQ(refusal_field(Json::object(), Json::parse(R"({"lens": {"size": null}})")),
            "unknown-field /lens/size");
  EXPECT_EQ(refusal_field(complete(), Json::parse(R"({"focus": {"shading": {"shine": null}}})")),
            "unknown-field /focus/shading/shine");
}

TEST(Patch, RefusesAModuleThatLosesItsName) {
  EXPECT_EQ(refusal_field(complete(), Json::parse(R"({"focus": {"shading": {"name": null}}})")),
            "missing-field /focus/shading/name");
}

TEST(Patch, AnotherVolumeForgetsWhatWasChosenForTheOld) {
  const Json forgotten = without_volume_choices(complete());
  for (const char* field :
       {"/volume", "/camera/eye_mm", "/camera/target_mm", "/camera/up", "/focus/surface/iso_value",
        "/context/surface/iso_value", "/lens/centre_mm", "/lens/radius_mm"})
    EXPECT_FALSE(forgotten.contains(Json::json_pointer(field))) << field;
  for (const char* field :
       {"/camera/projection", "/focus/shading", "/focus/surface/opacity", "/lens/mode"})
    EXPECT_TRUE(forgotten.contains(Json::json_pointer(field))) << field;
  EXPECT_EQ(without_volume_choices(Json::object()), Json::object());
}

}  // namespace
}  // namespace cutaway
