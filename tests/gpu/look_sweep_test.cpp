// From the scene's schema: each field of what gives surfaces their look apart from shading and
// filters, at both ends of its range and between, each of its choices, against the reference.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/shading/shading_registry.h"
#include "scene/json_text.h"
#include "scene/schema.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

const std::shared_ptr<const LoadedVolume>& looked_at_head() {
  static const auto volume = load(make_phantom({PhantomKind::head, 64}, {}, {}));
  return volume;
}

/// A lens under the skin of the face: there are caps, a wall, bone behind it and skin before it.
/// Both branches show how light falls on them.
Json looked_at() {
  const Json smooth = {{"name", "gooch"}};
  return {{"context",
           {{"surface", {{"iso_value", -200}}}, {"shading", smooth}, {"filters", Json::array()}}},
          {"focus",
           {{"surface", {{"iso_value", 250}}}, {"shading", smooth}, {"filters", Json::array()}}},
          {"light", {{"frame", "patient"}, {"direction", {-1, -1, 0.6}}}},
          {"lens", {{"mode", "cutaway"}, {"centre_mm", {10, -50, 15}}, {"radius_mm", 42}}}};
}

std::vector<Json> values_of(const Json& field) {
  if (field.contains("enum")) return field.at("enum").get<std::vector<Json>>();
  if (field.at("type") == "array") return {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  const double low = field.at("minimum");
  const double high = field.at("maximum");
  return {low, high, low + 0.37 * (high - low)};
}

/// Where it takes another field for this one to be read at all.
Json premise_of(const std::string& object, const std::string& field) {
  if (object == "wall" && field == "edge_colour") return {{"edge_mm", 8}};
  if (object == "wall" && field == "colour") return {{"strength", 0.7}};
  if (object == "lens" && field == "funnel_degrees") return {{"opening", "funnel"}};
  if (object == "occlusion" || object == "shadow") return {{"strength", 0.8}};
  return Json::object();
}

bool is_gaussian(const Normals& normals) {
  return normals.scale == NormalScale::automatic || normals.scale_mm > 0.0;
}

/// Where a Gaussian is asked for the reference integrates it: the taps' own error is a degree.
/// Newton's steps and the reference's bisection part at outlines, where the spline may have no
/// root. A march towards the light is stopped or not by what rounding makes of a sample.
Tolerance look_tolerance(const Scene& scene) {
  Tolerance tolerance = tolerance_for(scene);
  tolerance.share_of_disagreements = 0.002;
  for (const Branch* branch : {&scene.context, &scene.focus}) {
    if (is_gaussian(branch->normals))
      return {.mean = 1.0, .share_above_2 = 0.1, .share_of_disagreements = 0.002};
    const bool is_cubic = branch->normals.reconstruction == Reconstruction::cubic;
    const bool has_light = branch->occlusion.strength > 0.0 || branch->shadow.strength > 0.0;
    if (!is_cubic && !has_light) continue;
    tolerance.mean = std::max(tolerance.mean, 0.1);
    tolerance.share_above_2 = std::max(tolerance.share_above_2, 0.003);
    tolerance.maximum = std::max(tolerance.maximum, is_cubic ? 64 : 16);
  }
  return tolerance;
}

Scene look_scene(const Json& document) { return scene_for(document, looked_at_head(), {96, 72}); }

std::vector<std::uint8_t> drawn(const Json& document) {
  const Scene scene = look_scene(document);
  return GpuHarness::instance().render(scene, looked_at_head(), settings_for(scene)).rgba;
}

/// The fields of the object at `place` in scene and schema, or those of them that are named.
void sweep_object(const std::vector<std::string>& place, const std::vector<std::string>& named) {
  Json fields = schema("scene");
  std::string pointer;
  for (const std::string& name : place) {
    fields = Json(fields.at("properties").at(name));
    pointer += "/" + name;
  }
  for (const auto& [name, field] : fields.at("properties").items()) {
    if (!named.empty() && std::ranges::find(named, name) == named.end()) continue;
    const auto document_with = [&](const Json& value) {
      Json document = looked_at();
      Json& object = document[Json::json_pointer(pointer)];
      object.merge_patch(premise_of(place.back(), name));
      if (!value.is_null()) object[name] = value;
      return document;
    };
    const auto plain = drawn(document_with(nullptr));
    bool has_an_effect = false;
    for (const Json& value : values_of(field)) {
      const Json document = document_with(value);
      const Scene scene = look_scene(document);
      std::string title = "look" + pointer;
      title.append("-").append(name).append("-").append(json_text(value));
      expect_like_reference(title, scene, looked_at_head(), settings_for(scene),
                            look_tolerance(scene));
      has_an_effect = has_an_effect || drawn(document) != plain;
    }
    EXPECT_TRUE(has_an_effect) << pointer << "/" << name;
  }
}

class LookSweep : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(LookSweep, EveryFieldOfABranch) {
  const auto [branch, object] = GetParam();
  sweep_object({branch, object}, {});
}

INSTANTIATE_TEST_SUITE_P(Looks, LookSweep,
                         testing::Combine(testing::Values("context", "focus"),
                                          testing::Values("normals", "occlusion", "shadow")));

TEST(Looks, EveryFieldOfTheWall) { sweep_object({"lens", "wall"}, {}); }

TEST(Looks, EveryFieldOfTheCut) { sweep_object({"lens"}, {"cap", "opening", "funnel_degrees"}); }

TEST(Looks, EveryShadingModelWithLightKeptAway) {
  for (const ShadingModel& model : shading_models()) {
    Json document = looked_at();
    for (const char* branch : {"context", "focus"}) {
      document[branch]["shading"] = {{"name", model.name}};
      document[branch]["shadow"] = {{"strength", 0.8}};
      document[branch]["occlusion"] = {{"strength", 0.6}, {"colour", {0.3, 0.1, 0.2}}};
    }
    const Scene scene = look_scene(document);
    expect_like_reference(std::string("look-shadow-") + model.name, scene, looked_at_head(),
                          settings_for(scene), look_tolerance(scene));
  }
}

Json all_looks() {
  Json document = looked_at();
  for (const char* branch : {"context", "focus"}) {
    document[branch]["shading"] = {{"name", "tone"}, {"detail", 0.4}, {"softness", 2}};
    document[branch]["normals"] = {{"reconstruction", "cubic"}};
    document[branch]["shadow"] = {{"strength", 0.7}, {"softness_degrees", 8}};
    document[branch]["occlusion"] = {{"strength", 0.6}, {"range_mm", 40}, {"near_share", 0.4}};
  }
  document["lens"].merge_patch({{"opening", "funnel"},
                                {"cap", "section"},
                                {"shape", {{"name", "box"}, {"azimuth_degrees", 25}}},
                                {"wall",
                                 {{"strength", 0.4},
                                  {"colour", {0.5, 0.2, 0.2}},
                                  {"deepening", 0.8},
                                  {"edge_mm", 4},
                                  {"edge_colour", {1, 1, 1}}}}});
  return document;
}

TEST(Looks, AllTogetherOfSeveralRaysAPixelInEitherProjection) {
  for (const char* projection : {"perspective", "orthographic"}) {
    Json document = all_looks();
    document["camera"] = {{"projection", projection}};
    const Scene scene = look_scene(document);
    RenderSettings settings = settings_for(scene);
    settings.supersampling = 2;
    // A toon's step turns with what outlines' normals are.
    expect_like_reference(
        std::string("look-all-") + projection, scene, looked_at_head(), settings,
        {.mean = 0.15, .share_above_2 = 0.01, .maximum = 160, .share_of_disagreements = 0.002});
  }
}

}  // namespace
}  // namespace cutaway::test
