#include "scene/schema.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/modules.h"
#include "volume/geometry.h"

namespace cutaway {
namespace {

Error::Detail refusal(const Json& value, const char* name = "scene") {
  try {
    validate(value, name);
  } catch (const Error& error) {
    return error.detail();
  }
  return {};
}

/// A registry's names in the schema's order, as people are told them.
std::string names_of(const char* registry) {
  std::string names;
  for (const Json& module : describe_modules().at(registry))
    names += (names.empty() ? "" : ", ") + module.at("name").get<std::string>();
  return names;
}

TEST(Schema, ErrorsSayTheLimitWithItsUnitAndWhatCame) {
  const Error::Detail radius = refusal({{"lens", {{"radius_mm", 1e9}}}});
  EXPECT_EQ(radius.expected, "a number from 0 to 2000 mm");
  EXPECT_EQ(radius.received, "1000000000.0");
  EXPECT_EQ(refusal({{"lens", {{"cap", "round"}}}}).expected,
            "one of flat, gradient, open, section");
  EXPECT_EQ(refusal({{"camera", {{"up", {0, 1}}}}}).expected,
            "a list of 3 entries, each a number from -1000 to 1000");
  EXPECT_EQ(refusal({{"camera", {{"up", {0, 1}}}}}).received, "2 entries");
  EXPECT_EQ(refusal({{"focus", {{"shading", {{"name", "cel"}}}}}}).expected,
            "name one of " + names_of("shading"));
  EXPECT_EQ(refusal({{"light", {{"colour", 1}}}}).expected, "one of direction, frame");
  EXPECT_EQ(refusal({{"volume", ""}}).expected, "a string of 1 to 1024 characters");
}

TEST(Schema, ErrorsOfLongDocumentsAreShort) {
  const Error::Detail detail = refusal({{"lens", std::string(60000, 'x')}});
  EXPECT_LT(detail.received.size(), 100U);
  EXPECT_LT(refusal({{std::string(60000, 'x'), 1}}).field.size(), 300U);
}

TEST(Schema, FillsDefaultsAtEveryDepthAndKeepsWhatIsSaid) {
  const Json filled = with_defaults(
      Json::parse(R"({"focus": {"filters": [{"name": "sobel", "strength": 0.1}]}})"), "scene");
  EXPECT_EQ(filled.at("focus").at("filters"),
            Json::parse(R"([{"name": "sobel", "strength": 0.1, "mode": "darken", "source": "colour",
                               "silhouettes": true, "depth_step_mm": 100, "norm": "raw",
                "gradient": "l1"}])"));
  EXPECT_EQ(filled.at("context").at("shading").at("detail"), 0);
  EXPECT_EQ(filled.at("context").at("shading").at("lambert"), "half");
  EXPECT_EQ(filled.at("camera").at("vertical_fov_degrees"), 30);
  EXPECT_FALSE(filled.at("camera").contains("eye_mm"));
  EXPECT_NO_THROW(validate(filled, "scene"));
}

TEST(Schema, TellsTheRangeOfANumber) {
  const NumberRange range = number_range("scene", "/properties/lens/properties/radius_mm");
  EXPECT_EQ(range.minimum, 0.0);
  EXPECT_EQ(range.maximum, 2000.0);
}

/// Import refuses volumes by the one number, cameras and lenses are held to the other.
TEST(Schema, PositionsReachAsFarAsVolumesMay) {
  for (const char* place :
       {"camera/properties/eye_mm", "camera/properties/target_mm", "lens/properties/centre_mm"}) {
    const NumberRange range = number_range("scene", std::string("/properties/") + place + "/items");
    EXPECT_EQ(range.minimum, -kFarthestPosition_mm);
    EXPECT_EQ(range.maximum, kFarthestPosition_mm);
  }
}

const Json& found(const Json& list, const char* name) {
  for (const Json& entry : list)
    if (entry.at("name") == name) return entry;
  throw std::out_of_range(name);
}

TEST(Modules, AreDescribedInTheSchemasOrder) {
  const Json& modules = describe_modules();
  EXPECT_EQ(modules.at("shading").at(0).at("name"), "tone");
  std::string order;
  for (const Json& parameter : modules.at("shading").at(0).at("parameters"))
    order += parameter.at("name").get<std::string>() + " ";
  EXPECT_EQ(order, "detail dark light lambert terminator softness ");
  EXPECT_EQ(modules.at("lens_shape").at(0).at("name"), "sphere");
}

TEST(Modules, DescribeWhatAPanelNeeds) {
  const Json& modules = describe_modules();
  Json radius = found(found(modules.at("filter"), "kuwahara").at("parameters"), "radius");
  EXPECT_FALSE(radius.at("description").empty());
  radius.erase("description");
  EXPECT_EQ(radius, Json::parse(R"({"name": "radius", "title": "Radius", "type": "integer",
      "default": 2, "minimum": 0, "maximum": 15, "step": 1, "unit": "px", "level": "basic",
      "relative": {"name": "radius_per_mille", "minimum": 0, "maximum": 20, "step": 0.1,
                   "unit": "per mille of the height"}})"));
  const Json& tone = found(modules.at("shading"), "tone").at("parameters");
  EXPECT_EQ(found(tone, "dark").at("type"), "colour");
  EXPECT_EQ(found(tone, "lambert").at("type"), "choice");
  EXPECT_EQ(found(tone, "lambert").at("choices"), Json::parse(R"(["half", "clamped"])"));
}

TEST(Modules, OfBothBranchesAreTheSame) {
  const Json& properties = schema("scene").at("properties");
  for (const char* part : {"/properties/shading/oneOf", "/properties/filters/items"})
    EXPECT_EQ(properties.at("focus").at(Json::json_pointer(part)),
              properties.at("context").at(Json::json_pointer(part)));
}

}  // namespace
}  // namespace cutaway
