#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/schema.h"
#include "scene/styles.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

Scene look(const Json& document) { return resolve_scene(document, ball_facts(), {640, 480}); }

/// Every field that a scene says, modules as one.
void collect_fields(const Json& value, const std::string& pointer, std::set<std::string>& fields) {
  if (!value.is_object() || value.contains("name")) {
    fields.insert(pointer);
    return;
  }
  for (const auto& [key, field] : value.items())
    collect_fields(field, pointer_to(pointer, key), fields);
}

std::set<std::string> fields_of(const Style& style) {
  std::set<std::string> fields;
  collect_fields(style.scene, "", fields);
  return fields;
}

TEST(Styles, FollowTheSchemaAndResolve) {
  EXPECT_GE(styles().size(), 6U);
  for (const Json& style : describe_styles()) {
    EXPECT_NO_THROW(validate(style, "style")) << style.at("name");
    EXPECT_NO_THROW(look(style.at("scene"))) << style.at("name");
  }
}

TEST(Styles, BeginWithTheFlagship) { EXPECT_EQ(styles().front().name, "flagship"); }

/// What old documents leave open is as it was.
TEST(Styles, TheDissertationsIsTheSchemasOwnLook) {
  EXPECT_EQ(look(style("dissertation").scene), look(Json::object()));
}

/// CIE L*a*b* (D65) of display-encoded sRGB.
glm::dvec3 lab_of(const Json& srgb) {
  glm::dvec3 linear;
  for (int i = 0; i < 3; ++i) {
    const double value = srgb.at(i).get<double>();
    linear[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  const glm::dvec3 white(0.95047, 1.0, 1.08883);
  const glm::dvec3 xyz = glm::dvec3(glm::dot(glm::dvec3(0.4124, 0.3576, 0.1805), linear),
                                    glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), linear),
                                    glm::dot(glm::dvec3(0.0193, 0.1192, 0.9505), linear)) /
                         white;
  glm::dvec3 f;
  for (int i = 0; i < 3; ++i)
    f[i] = xyz[i] > 0.008856 ? std::cbrt(xyz[i]) : 7.787 * xyz[i] + 16.0 / 116.0;
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

TEST(Styles, TheDissertationsFocusIsThreeTimesAsColourfulAsItsContext) {
  const auto contrast = [](const char* branch) {
    const Json& shading = style("dissertation").scene.at(branch).at("shading");
    return glm::distance(lab_of(shading.at("dark")), lab_of(shading.at("light")));
  };
  EXPECT_GE(contrast("focus"), 3.0 * contrast("context"));
}

TEST(Styles, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Style& style : styles()) EXPECT_TRUE(names.insert(style.name).second) << style.name;
}

TEST(Styles, SaysNothingOfVolumeCameraOrPlace) {
  for (const Style& style : styles())
    for (const char* field :
         {"/volume", "/camera", "/viewport", "/lens/centre_mm", "/lens/radius_mm",
          "/focus/surface/iso_value", "/context/surface/iso_value"})
      EXPECT_FALSE(style.scene.contains(Json::json_pointer(field))) << style.name << field;
}

TEST(Styles, ReplaceEachOther) {
  for (const Style& one : styles()) {
    EXPECT_EQ(fields_of(one), fields_of(styles().front())) << one.name;
    for (const Style& other : styles())
      EXPECT_EQ(look(patch_scene_document(one.scene, other.scene)), look(other.scene))
          << one.name << " then " << other.name;
  }
}

TEST(Styles, AreFoundByName) {
  EXPECT_EQ(style("toon").title, "Toon");
  try {
    style("watercolour");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::unknown_style);
    EXPECT_NE(error.detail().expected.find("flagship"), std::string::npos);
  }
}

}  // namespace
}  // namespace cutaway
