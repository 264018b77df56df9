#include "scene/resolve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "scene/schema.h"
#include "scene/view_geometry.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

Scene resolved(const char* text, Viewport viewport = {640, 480}) {
  return resolve_scene(Json::parse(text), ball_facts(), viewport);
}

/// The box's corners in the picture, as fractions of the viewport: 1 is its edge.
glm::dvec2 farthest_corner(const Scene& scene, const VolumeFacts& facts) {
  glm::dvec2 farthest{0.0};
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 point = facts.bounds_minimum_mm;
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis) & 1) point[axis] = facts.bounds_maximum_mm[axis];
    const glm::dvec2 middle{0.5 * scene.viewport.width_px, 0.5 * scene.viewport.height_px};
    const auto pixel = project_px(scene.camera, scene.viewport, point);
    if (!pixel) return glm::dvec2(INFINITY);
    farthest = glm::max(farthest, glm::abs(*pixel - middle) / middle);
  }
  return farthest;
}

TEST(Resolve, FramesTheVolumeFromTheFrontInAnyAspect) {
  for (const Viewport viewport : {Viewport{640, 480}, {1000, 200}, {200, 1000}, {1, 1}}) {
    for (const char* document : {"{}", R"({"camera": {"projection": "orthographic"}})",
                                 R"({"camera": {"vertical_fov_degrees": 90}})"}) {
      const Scene scene = resolved(document, viewport);
      const glm::dvec2 farthest = farthest_corner(scene, ball_facts());
      EXPECT_NEAR(std::max(farthest.x, farthest.y), 1.0 / 1.05, 1e-9) << document;
      EXPECT_EQ(scene.camera.target_mm, kBallCentre_mm);
      EXPECT_LT(scene.camera.eye_mm.y, ball_facts().bounds_minimum_mm.y);
    }
  }
}

TEST(Resolve, PutsTheLensOnTheSurfaceInTheMiddleOfTheView) {
  const Scene front = resolved("{}");
  const glm::dvec3 nearest = kBallCentre_mm - glm::dvec3(0.0, kBallRadius_mm, 0.0);
  EXPECT_LT(glm::distance(front.lens.centre_mm, nearest), 1e-9);
  EXPECT_DOUBLE_EQ(front.lens.radius_mm, 0.15 * ball_facts().diagonal_mm);

  const Scene above =
      resolved(R"({"camera": {"eye_mm": [10, -20, 900]}, "lens": {"radius_mm": 60}})");
  EXPECT_LT(glm::distance(above.lens.centre_mm, kBallCentre_mm + glm::dvec3(0, 0, kBallRadius_mm)),
            1e-9);
}

TEST(Resolve, LooksAtASlabFromItsFront) {
  VolumeFacts facts = ball_facts();
  SlabView& slab = facts.slab.emplace();
  slab.centre_mm = {5.0, 6.0, 7.0};
  slab.to_viewer = glm::normalize(glm::dvec3(0.0, -0.6, -0.8));
  slab.up = glm::normalize(glm::dvec3(0.0, -0.8, 0.6));
  slab.half_axes_mm = {glm::dvec3(90.0, 0.0, 0.0), 60.0 * slab.up, 4.0 * slab.to_viewer};
  const Scene scene = resolve_scene(Json::object(), facts, {640, 480});
  const glm::dvec3 to_eye = scene.camera.eye_mm - slab.centre_mm;
  EXPECT_EQ(scene.camera.target_mm, slab.centre_mm);
  EXPECT_LT(glm::length(glm::cross(glm::normalize(to_eye), slab.to_viewer)), 1e-9);
  EXPECT_LT(glm::distance(scene.camera.up, slab.up), 1e-9);
  // Its front fills the view to 5 %: 2 x 90 mm across four thirds of the height.
  const double seen_mm = 2.0 * std::tan(glm::radians(15.0)) * (glm::length(to_eye) - 4.0);
  EXPECT_NEAR(seen_mm, 1.05 * 180.0 * 480.0 / 640.0, 1e-6);
  const Scene turned =
      resolve_scene(Json::parse(R"({"camera": {"eye_mm": [900, 0, 0]}})"), facts, {640, 480});
  EXPECT_EQ(turned.camera.up, glm::dvec3(0.0, 0.0, 1.0));
}

VolumeFacts facts_of_ct_with_couch() {
  VolumeFacts facts = ball_facts();
  facts.first_preparation = {.hide_couch = true, .fill_context = true, .focus_islands_ml = 0.5};
  return facts;
}

TEST(Resolve, PreparesTheVolumeForAFirstLook) {
  const VolumeFacts facts = facts_of_ct_with_couch();
  const Scene scene = resolve_scene(Json::object(), facts, {640, 480});
  EXPECT_EQ(scene.preparation, facts.first_preparation);
  EXPECT_EQ(resolve_scene(scene_document(scene), facts, {640, 480}), scene);
  const Scene with_couch =
      resolve_scene(Json::parse(R"({"preparation": {"hide_couch": false}})"), facts, {640, 480});
  EXPECT_FALSE(with_couch.preparation.hide_couch);
  EXPECT_TRUE(with_couch.preparation.fill_context);
  EXPECT_EQ(with_couch.preparation.focus_islands_ml, 0.5);
}

/// A link of the time before there was any draws what it drew.
TEST(Resolve, PreparesNothingWhereTheDocumentSaysItsSurface) {
  const Json document = Json::parse(R"({"context": {"surface": {"iso_value": -200}}})");
  const Scene scene = resolve_scene(document, facts_of_ct_with_couch(), {640, 480});
  EXPECT_EQ(scene.preparation, Preparation{});
}

TEST(Resolve, PutsTheLensInTheVolumeWhereTheViewMissesTheSurface) {
  const Scene scene = resolved(R"({"camera": {"target_mm": [900, 900, 900]}})");
  EXPECT_EQ(scene.lens.centre_mm, kBallCentre_mm);
}

TEST(Resolve, TakesIsoValuesOfTheVolume) {
  const Scene scene = resolved("{}");
  EXPECT_EQ(scene.focus.surface.band.lower, 250.0);
  EXPECT_EQ(scene.context.surface.band.lower, -200.0);
}

TEST(Resolve, TakesWhatTheDocumentSays) {
  const Scene scene =
      resolved(R"({"volume": "other", "camera": {"eye_mm": [1, 2, 3], "up": [1, 0, 0]},
      "context": {"surface": {"iso_value": 7}},
      "lens": {"centre_mm": [4, 5, 6], "radius_mm": 0}})");
  EXPECT_EQ(scene.volume, "other");
  EXPECT_EQ(scene.camera.eye_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.camera.up, glm::dvec3(1, 0, 0));
  EXPECT_EQ(scene.context.surface.band.lower, 7.0);
  EXPECT_EQ(scene.lens.centre_mm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(scene.lens.radius_mm, 0.0);
}

TEST(Resolve, FillsEveryParameterOfAModule) {
  const Scene scene = resolved(R"({"focus": {"shading": {"name": "phong", "exponent": 7}}})");
  EXPECT_EQ(scene.focus.shading.parameters, Json::parse(R"({"model": "phong",
      "colour": [0.86, 0.81, 0.73], "ambient": 0.15, "diffuse": 0.75, "specular": 0.25,
      "exponent": 7})"));
  ASSERT_EQ(scene.context.filters.size(), 1U);
  EXPECT_EQ(scene.context.filters[0].name, "kuwahara");
  EXPECT_EQ(scene.context.filters[0].parameters, Json::parse(R"({"radius": 2})"));
}

TEST(Resolve, ChoosesAnUpThatIsNotTheView) {
  const Scene scene = resolved(R"({"camera": {"eye_mm": [0, 0, 500], "target_mm": [0, 0, 0]}})");
  EXPECT_EQ(scene.camera.up, glm::dvec3(0, -1, 0));
}

TEST(Resolve, OfItsOwnDocumentGivesTheSameScene) {
  for (const char* document :
       {"{}", R"({"camera": {"projection": "orthographic", "eye_mm": [0.1, -333.3, 1e-7]}})",
        R"({"lens": {"mode": "none", "cap": "open"}, "light": {"frame": "patient"}})",
        R"({"context": {"shading": {"name": "phong", "model": "blinn"}, "filters": []}})"}) {
    const Scene scene = resolved(document);
    const Json complete = scene_document(scene);
    EXPECT_EQ(resolve_scene(complete, ball_facts(), scene.viewport), scene) << document;
    EXPECT_EQ(resolve_scene(Json::parse(complete.dump()), ball_facts(), scene.viewport), scene);
  }
}

/// An enumerator that is not told to the JSON library would silently become another.
TEST(Resolve, KnowsEveryChoiceOfTheSchema) {
  for (const char* field : {"/lens/mode", "/lens/cap", "/camera/projection", "/light/frame"}) {
    std::string in_schema = field;
    in_schema.replace(in_schema.rfind('/'), 1, "/properties/");
    const Json& choices =
        schema("scene").at(Json::json_pointer("/properties" + in_schema + "/enum"));
    for (const Json& choice : choices) {
      Json document = Json::object();
      document[Json::json_pointer(field)] = choice;
      EXPECT_EQ(scene_document(resolve_scene(document, ball_facts(), {64, 64}))
                    .at(Json::json_pointer(field)),
                choice);
    }
  }
}

TEST(Resolve, RefusesABandWithoutValuesAndAFilterTwice) {
  const auto refusal = [](const char* text) {
    try {
      resolved(text);
    } catch (const Error& error) {
      return std::string(code_word(error.detail().code)) + " " + error.detail().field;
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal(R"({"context": {"surface": {"upper_value": -200}}})"),
            "invalid-scene /context/surface/upper_value");
  EXPECT_EQ(refusal(R"({"focus": {"filters": [{"name": "sobel"}, {"name": "sobel"}]}})"),
            "invalid-scene /focus/filters/1");
}

TEST(Resolve, TakesParametersByTheirSecondNamesAndAnswersWithTheirFirst) {
  const Scene scene = resolved(R"({"focus": {"shading": {"name": "tone", "ts": 0.25}},
      "context": {"filters": [{"name": "kuwahara", "window": 10}]}})");
  EXPECT_EQ(scene.focus.shading.parameters.at("detail"), 0.5);
  EXPECT_FALSE(scene.focus.shading.parameters.contains("ts"));
  EXPECT_EQ(scene.context.filters.at(0).parameters, Json::parse(R"({"radius": 5})"));
}

TEST(Resolve, LeavesTheLensWhereItIsWhileTheCameraMoves) {
  const Scene first = resolved("{}");
  const Json moved =
      patch_scene_document(scene_document(first), {{"camera", {{"eye_mm", {500, 0, 0}}}}});
  EXPECT_EQ(resolve_scene(moved, ball_facts(), first.viewport).lens, first.lens);
}

TEST(Resolve, OfAVolumeBeyondTheLimitsIsStillALegalDocument) {
  VolumeFacts facts = ball_facts();
  facts.bounds_minimum_mm = glm::dvec3(-9e4);
  facts.bounds_maximum_mm = glm::dvec3(9e4);
  facts.diagonal_mm = 3e5;
  facts.outer_iso_value = -1e39;
  facts.inner_iso_value = 1e39;
  const Scene scene = resolve_scene({{"camera", {{"vertical_fov_degrees", 1}}}}, facts, {64, 64});
  EXPECT_NO_THROW(validate_scene_document(scene_document(scene)));
}

TEST(Resolve, ChoosesIsoValuesOfAnySizeThatVoxelsHave) {
  for (const double value : {-2.5e30, 4e6, 1e12, 3e38}) {
    VolumeFacts facts = ball_facts();
    facts.outer_iso_value = value;
    facts.inner_iso_value = value;
    const Scene scene = resolve_scene(Json::object(), facts, {64, 64});
    EXPECT_EQ(scene.context.surface.band.lower, value);
    EXPECT_EQ(scene.focus.surface.band.lower, value);
    EXPECT_EQ(resolve_scene(scene_document(scene), ball_facts(), {64, 64}).focus, scene.focus);
  }
}

TEST(Resolve, ReadsThePictureSizeOfADocument) {
  EXPECT_EQ(document_viewport(Json::object()), (Viewport{1024, 768}));
  EXPECT_EQ(document_viewport(Json::parse(R"({"viewport": {"width_px": 300}})")),
            (Viewport{300, 768}));
}

TEST(Resolve, WorksBeforeTheViewportIsKnown) {
  EXPECT_EQ(resolved("{}", {0, 0}).camera, resolved("{}", {100, 100}).camera);
}

}  // namespace
}  // namespace cutaway
