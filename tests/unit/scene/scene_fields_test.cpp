// What belongs to the look, the volume and the view, from the schema alone.
#include "scene/scene_fields.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/scene_json.h"
#include "scene/scene_visit.h"
#include "scene/schema.h"
#include "scene/schema_node.h"
#include "scene/styles.h"
#include "unit/scene/fixtures.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

std::set<std::string> pointers(BelongsTo belongs_to) {
  std::set<std::string> result;
  for (const SceneField& field : scene_fields())
    if (field.belongs_to == belongs_to) result.insert(field.pointer.to_string());
  return result;
}

TEST(SceneFields, BelongSomewhere) {
  for (const BelongsTo part :
       {BelongsTo::look, BelongsTo::volume, BelongsTo::view, BelongsTo::document})
    EXPECT_FALSE(pointers(part).empty());
  EXPECT_TRUE(pointers(BelongsTo::look).contains("/context/surface/opacity"));
  EXPECT_TRUE(pointers(BelongsTo::volume).contains("/focus/surface/iso_value"));
  EXPECT_TRUE(pointers(BelongsTo::view).contains("/slices/convention"));
}

TEST(SceneFields, FixturesArePartedAsInTheOtherLanguage) {
  const auto fixtures = json_fixtures("belongings");
  EXPECT_FALSE(fixtures.empty());
  for (const auto& [name, fixture] : fixtures) {
    const Json& scene = fixture.at("scene");
    EXPECT_EQ(only_fields(scene, BelongsTo::look), fixture.at("look")) << name;
    EXPECT_EQ(without_fields(scene, BelongsTo::volume), fixture.at("in_another_volume")) << name;
  }
}

TEST(SceneFields, AStyleReplacesTheOpacityOfTheOneBefore) {
  const Json translucent = scene_document(
      resolve_scene({{"context", {{"surface", {{"opacity", 0.05}}}}}}, ball_facts(), {640, 480}));
  for (const Style& style : styles()) {
    const Json worn = patch_scene_document(translucent, style.scene);
    EXPECT_EQ(worn.at("/context/surface/opacity"_json_pointer), 1.0) << style.name;
  }
}

TEST(SceneFields, ASlicesPatchIsForTheSlicesAlone) {
  const Json slices{{"slices", {{"crosshair_mm", {1, 2, 3}}}}};
  EXPECT_TRUE(is_read_only_by(OnlyReader::slices, slices));
  EXPECT_TRUE(is_read_only_by(OnlyReader::slices, {{"slices", nullptr}}));
  Json both = slices;
  both["light"]["frame"] = "patient";
  EXPECT_FALSE(is_read_only_by(OnlyReader::slices, both));
  EXPECT_TRUE(is_read_only_by(OnlyReader::composite, {{"lens", {{"strength", 0.1}}}}));
  EXPECT_FALSE(is_read_only_by(OnlyReader::composite, {{"lens", {{"radius_mm", 1}}}}));
}

template <typename T>
void expect_fields_of(const T& value, const Json& node, const std::string& pointer);

/// A choice has a word for each that the schema has, and no other.
template <typename T>
void expect_choices(const Json& node, const std::string& pointer) {
  for (const Json& word : node.at("enum"))
    EXPECT_EQ(Json(word.get<T>()), word) << pointer << ": the C++ type lacks a choice";
}

template <typename T>
void expect_field(const T& value, const Json& node, const std::string& pointer) {
  if constexpr (std::is_enum_v<T>)
    expect_choices<T>(node, pointer);
  else if constexpr (requires { visit_fields(value, [](const char*, const auto&) {}); })
    expect_fields_of(value, node, pointer);
}

template <typename T>
void expect_fields_of(const T& value, const Json& node, const std::string& pointer) {
  std::set<std::string> visited;
  visit_fields(value, [&](const char* name, const auto& field) {
    const Json* child = property(node, name);
    ASSERT_NE(child, nullptr) << pointer << "/" << name << " is not in the schema";
    expect_field(field, *child, pointer_to(pointer, name));
    visited.insert(name);
  });
  for (const auto& [name, child] : node.at("properties").items())
    EXPECT_TRUE(visited.contains(name) || name == "version" || name == "viewport")
        << pointer << "/" << name << " is not in the C++ type";
}

TEST(SceneVisit, MeetsEveryFieldOfTheSchemaAndEveryChoice) {
  expect_fields_of(Scene{}, schema("scene"), "");
  expect_fields_of(Viewport{}, schema("scene").at("properties").at("viewport"), "/viewport");
}

}  // namespace
}  // namespace cutaway
