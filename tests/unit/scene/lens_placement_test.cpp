#include "scene/lens_placement.h"

#include <gtest/gtest.h>

#include "scene/view_geometry.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

/// Looking at the ball from the front; iso-values above 0 are bone.
LensPlacementView front_view() {
  LensPlacementView view;
  view.camera.eye_mm = kBallCentre_mm - glm::dvec3(0.0, 500.0, 0.0);
  view.camera.target_mm = kBallCentre_mm;
  view.camera.up = {0.0, 0.0, 1.0};
  view.camera.vertical_fov_degrees = 30.0;
  view.viewport = {600, 400};
  view.context.lower = -200.0;
  view.focus.lower = 250.0;
  view.shape = {"sphere", Json::object()};
  return view;
}

/// The ball with bone only in a small ball under its skin, on the patient's left.
VolumeFacts ball_with_bone_on_the_left() {
  VolumeFacts facts = ball_facts();
  const auto skin = facts.first_surface_mm;
  facts.first_surface_mm = [skin](glm::dvec3 origin_mm, glm::dvec3 direction,
                                  const ValueBand& band) {
    if (band.lower < 0.0) return skin(origin_mm, direction, band);
    // first_point_on_ball knows one centre: the ray is moved instead of the ball.
    const glm::dvec3 shift(40.0, -30.0, 0.0);
    auto point = first_point_on_ball(origin_mm - shift, direction, 20.0);
    if (point) *point += shift;
    return point;
  };
  return facts;
}

TEST(LensPlacement, StaysInTheMiddleWhereThatShowsTheFocus) {
  const auto lens = placed_lens(ball_facts(), front_view(), 50.0);
  ASSERT_TRUE(lens);
  EXPECT_LT(glm::distance(lens->centre_mm, kBallCentre_mm - glm::dvec3(0.0, kBallRadius_mm, 0.0)),
            1e-9);
}

TEST(LensPlacement, GoesToTheFocusOnTheSkin) {
  const auto lens = placed_lens(ball_with_bone_on_the_left(), front_view(), 25.0);
  ASSERT_TRUE(lens);
  EXPECT_NEAR(glm::distance(lens->centre_mm, kBallCentre_mm), kBallRadius_mm, 1e-6);
  EXPECT_GT(lens->centre_mm.x, kBallCentre_mm.x + 20.0) << "the bone is on the left, +x";
  EXPECT_NEAR(lens->centre_mm.z, kBallCentre_mm.z, 15.0);
}

TEST(LensPlacement, StaysInTheMiddleWhereNothingShowsTheFocus) {
  VolumeFacts facts = ball_facts();
  const auto skin = facts.first_surface_mm;
  facts.first_surface_mm = [skin](glm::dvec3 origin_mm, glm::dvec3 direction,
                                  const ValueBand& band) {
    return band.lower < 0.0 ? skin(origin_mm, direction, band) : std::nullopt;
  };
  const auto lens = placed_lens(facts, front_view(), 30.0);
  ASSERT_TRUE(lens);
  EXPECT_LT(glm::distance(lens->centre_mm, kBallCentre_mm - glm::dvec3(0.0, kBallRadius_mm, 0.0)),
            1e-9);
}

TEST(LensPlacement, SinksToAFocusThatLiesTooDeep) {
  VolumeFacts facts = ball_facts();
  facts.first_surface_mm = [](glm::dvec3 origin_mm, glm::dvec3 direction, const ValueBand& band) {
    return first_point_on_ball(origin_mm, direction, band.lower < 0.0 ? kBallRadius_mm : 30.0);
  };
  const auto lens = placed_lens(facts, front_view(), 40.0);  // the focus is 50 mm deep
  ASSERT_TRUE(lens);
  const double depth_mm = kBallRadius_mm - glm::distance(lens->centre_mm, kBallCentre_mm);
  EXPECT_GT(depth_mm + lens->radius_mm, 50.0) << "it reaches the focus";
  EXPECT_LT(depth_mm, lens->radius_mm) << "it still opens the surface";
}

TEST(LensPlacement, FindsTheSurfaceBesideTheMiddle) {
  LensPlacementView view = front_view();
  view.camera.target_mm.x += 100.0;  // the ball is in the picture's left half now
  const auto lens = placed_lens(ball_facts(), view, 60.0);
  ASSERT_TRUE(lens);
  EXPECT_NEAR(glm::distance(lens->centre_mm, kBallCentre_mm), kBallRadius_mm, 1e-6);
}

/// The box cuts off the ball's front below the middle and on the patient's left.
TEST(LensPlacement, IsNotWhereTheBoxCutsTheBody) {
  VolumeFacts facts = ball_facts();
  const auto whole = facts.first_surface_mm;
  const double face_y = kBallCentre_mm.y - 70.0;
  facts.grid_centre_mm.y = face_y + 100.0;
  facts.grid_half_axes_mm[1] = {0.0, 101.0, 0.0};
  facts.outermost_share = {1.0, 100.0 / 101.0, 1.0};
  facts.first_surface_mm = [=](glm::dvec3 origin_mm, glm::dvec3 direction, const ValueBand& band) {
    auto point = whole(origin_mm, direction, band);
    if (point && point->y < face_y)
      *point = origin_mm + direction * ((face_y - origin_mm.y) / direction.y);
    return point;
  };
  const auto lens = placed_lens(facts, front_view(), 30.0);
  ASSERT_TRUE(lens);
  EXPECT_GT(lens->centre_mm.y, face_y + 0.5) << "the face is a disc of 39 mm about the middle";
}

/// A volume cropped within the body: what is not cut is a strip at the upper edge.
TEST(LensPlacement, IsInTheMiddleWhereTheBoxCutsMostOfTheBody) {
  VolumeFacts facts = ball_facts();
  facts.grid_half_axes_mm[1] = {0.0, 101.0, 0.0};
  facts.outermost_share = {2.0, 100.0 / 101.0, 2.0};
  facts.first_surface_mm = [](glm::dvec3 origin_mm, glm::dvec3 direction, const ValueBand& band) {
    const auto on_plane = [&](double y) {
      return origin_mm + direction * ((y - origin_mm.y) / direction.y);
    };
    const double face_y = kBallCentre_mm.y - 100.0;
    const glm::dvec3 on_face = on_plane(band.lower > 0.0 ? face_y + 10.0 : face_y);
    return std::optional(on_face.z < kBallCentre_mm.z + 60.0 ? on_face : on_plane(face_y + 3.0));
  };
  const auto lens = placed_lens(facts, front_view(), 30.0);
  ASSERT_TRUE(lens);
  EXPECT_LT(glm::distance(lens->centre_mm, kBallCentre_mm - glm::dvec3(0.0, 100.0, 0.0)), 1e-6);
}

/// A plate 10 mm thick with bone through all of it on the patient's left.
TEST(LensPlacement, OpensAPartOfASlabOnly) {
  constexpr double kFront_y = -25.0;
  VolumeFacts facts = ball_facts();
  facts.slab = SlabView{.centre_mm = {kBallCentre_mm.x, kFront_y + 5.0, kBallCentre_mm.z},
                        .half_axes_mm = {glm::dvec3(90.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 80.0),
                                         glm::dvec3(0.0, 5.0, 0.0)}};
  facts.first_surface_mm = [](glm::dvec3 origin_mm, glm::dvec3 direction,
                              const ValueBand& band) -> std::optional<glm::dvec3> {
    const glm::dvec3 point = origin_mm + direction * ((kFront_y - origin_mm.y) / direction.y);
    if (band.lower > 0.0 && point.x < kBallCentre_mm.x + 40.0) return std::nullopt;
    return point;
  };
  for (const double radius_mm : {25.0, 50.0}) {
    const auto lens = placed_lens(facts, front_view(), radius_mm);
    ASSERT_TRUE(lens);
    EXPECT_NEAR(lens->centre_mm.y + lens->radius_mm, kFront_y + 7.5, 0.3) << radius_mm;
    EXPECT_GT(lens->centre_mm.x, kBallCentre_mm.x + 20.0) << "there is the bone";
  }
}

TEST(LensPlacement, IsTheSameInAWiderViewport) {
  for (const auto& facts : {ball_facts(), ball_with_bone_on_the_left()}) {
    LensPlacementView view = front_view();
    const auto lens = placed_lens(facts, view, 25.0);
    view.viewport.width_px = 1000;
    const auto in_wider = placed_lens(facts, view, 25.0);
    ASSERT_TRUE(lens && in_wider);
    EXPECT_LT(glm::distance(lens->centre_mm, in_wider->centre_mm), 1e-9);
  }
}

TEST(LensPlacement, LeavesTheMiddleUpOrDownBeforeItDoesSideways) {
  VolumeFacts facts = ball_facts();
  const auto skin = facts.first_surface_mm;
  facts.first_surface_mm = [skin](glm::dvec3 origin_mm, glm::dvec3 direction,
                                  const ValueBand& band) {
    auto point = skin(origin_mm, direction, band);
    // Bone far above the middle, and far beside it.
    if (band.lower > 0.0 && point && point->z < kBallCentre_mm.z + 30.0 &&
        std::abs(point->x - kBallCentre_mm.x) < 70.0)
      point.reset();
    return point;
  };
  const auto lens = placed_lens(facts, front_view(), 40.0);
  ASSERT_TRUE(lens);
  EXPECT_NEAR(lens->centre_mm.x, kBallCentre_mm.x, 1e-6);
  EXPECT_GT(lens->centre_mm.z, kBallCentre_mm.z + 3.0);
}

TEST(LensPlacement, IsNowhereWhereTheViewMissesTheSurface) {
  LensPlacementView view = front_view();
  view.camera.target_mm = view.camera.eye_mm - glm::dvec3(0.0, 500.0, 0.0);
  EXPECT_FALSE(placed_lens(ball_facts(), view, 30.0));
}

}  // namespace
}  // namespace cutaway
