#include "scene/relative_lengths.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/resolve.h"
#include "scene/schema.h"

namespace cutaway {
namespace {

Json with_filter(const Json& filter) { return {{"context", {{"filters", {filter}}}}}; }

Error::Detail refusal(const Json& base, const Json& patch) {
  try {
    patch_scene_document(base, patch);
  } catch (const Error& error) {
    return error.detail();
  }
  return {};
}

/// Every module that a scene may hold.
template <typename Visit>
void each_module(Visit&& visit) {
  for (const char* place :
       {"/properties/focus/properties/shading", "/properties/focus/properties/filters/items"})
    for (const Json& module : schema("scene").at(Json::json_pointer(place)).at("oneOf"))
      visit(module.at("properties"));
}

TEST(RelativeLengths, AreTwinsOfLengthsInPixels) {
  int twins = 0;
  each_module([&](const Json& parameters) {
    for (const auto& [name, twin] : parameters.items()) {
      if (!is_per_mille(name)) continue;
      const std::string pixels = name.substr(0, name.size() - std::string("_per_mille").size());
      ASSERT_TRUE(parameters.contains(pixels)) << name;
      EXPECT_EQ(parameters.at(pixels).at("x-unit"), "px") << pixels;
      EXPECT_EQ(twin.at("type"), "number") << name;
      EXPECT_FALSE(twin.contains("default")) << name;
      ++twins;
    }
  });
  EXPECT_GE(twins, 2);
}

TEST(RelativeLengths, AreThereForEveryLengthInPixels) {
  each_module([](const Json& parameters) {
    for (const auto& [name, parameter] : parameters.items())
      if (parameter.value("x-unit", "") == "px" && !parameter.contains("x-alias")) {
        EXPECT_TRUE(parameters.contains(per_mille_name(name))) << name;
      }
  });
}

TEST(RelativeLengths, BecomePixelsOfTheViewport) {
  const Module said{"kuwahara", {{"radius_per_mille", 5.0}, {"other", 1}}};
  EXPECT_EQ(in_pixels(said, 1000).parameters, Json({{"radius", 5.0}, {"other", 1}}));
  EXPECT_EQ(in_pixels(said, 8192).parameters.at("radius"), 40.96);
  const Module pixels{"kuwahara", {{"radius", 3}}};
  EXPECT_EQ(in_pixels(pixels, 8192), pixels);
}

TEST(RelativeLengths, TakeThePlaceOfTheDefaultInPixels) {
  const Json filled =
      with_defaults(with_filter({{"name", "kuwahara"}, {"radius_per_mille", 4}}), "scene");
  EXPECT_EQ(filled.at("context").at("filters").at(0),
            Json({{"name", "kuwahara"}, {"radius_per_mille", 4}}));
}

TEST(RelativeLengths, AreReplacedByPixelsAndTheOtherWayRound) {
  const Json shading = {{"name", "tone"}, {"softness", 2}};
  Json scene = {{"focus", {{"shading", shading}}}};
  scene = patch_scene_document(scene, {{"focus", {{"shading", {{"softness_per_mille", 3}}}}}});
  EXPECT_EQ(scene.at("focus").at("shading"), Json({{"name", "tone"}, {"softness_per_mille", 3}}));
  scene = patch_scene_document(scene, {{"focus", {{"shading", {{"softness", 4}}}}}});
  EXPECT_EQ(scene.at("focus").at("shading"), Json({{"name", "tone"}, {"softness", 4}}));
  const Json nulls = {{"softness", nullptr}, {"softness_per_mille", 1}};
  scene = patch_scene_document(scene, {{"focus", {{"shading", nulls}}}});
  EXPECT_EQ(scene.at("focus").at("shading"), Json({{"name", "tone"}, {"softness_per_mille", 1}}));
}

TEST(RelativeLengths, AreRefusedBesidePixels) {
  const Error::Detail both = refusal(
      Json::object(), with_filter({{"name", "kuwahara"}, {"radius", 2}, {"radius_per_mille", 3}}));
  EXPECT_EQ(both.code, ErrorCode::invalid_scene);
  EXPECT_EQ(both.field, "/context/filters/0/radius_per_mille");
  EXPECT_EQ(both.message, "radius_per_mille is radius in another unit, and both are there");
  EXPECT_EQ(both.expected, "one of the two");
  // An alias of the pixels is pixels, too.
  EXPECT_EQ(refusal(Json::object(),
                    with_filter({{"name", "kuwahara"}, {"window", 5}, {"radius_per_mille", 3}}))
                .code,
            ErrorCode::invalid_scene);
}

}  // namespace
}  // namespace cutaway
