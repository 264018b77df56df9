#include "scene/admitted.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/resolve.h"
#include "scene/schema.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLargestFloat = std::numeric_limits<float>::max();

VolumeFacts with_values(double lowest, double highest) {
  VolumeFacts facts = ball_facts();
  facts.minimum_value = facts.outer_iso_value = lowest;
  facts.maximum_value = facts.inner_iso_value = highest;
  facts.window_centre = 0.5 * lowest + 0.5 * highest;
  facts.window_width = highest - lowest;
  return facts;
}

VolumeFacts of_size(double factor) {
  VolumeFacts facts = ball_facts();
  facts.first_surface_mm = nullptr;
  for (glm::dvec3* place : {&facts.bounds_minimum_mm, &facts.bounds_maximum_mm,
                            &facts.grid_centre_mm, &facts.middle_voxel_mm})
    *place *= factor;
  facts.grid_half_axes_mm *= factor;
  facts.diagonal_mm *= factor;
  return facts;
}

/// What is chosen becomes the session's document: were it refused, every message after it would be.
TEST(Admitted, WhatIsChosenForAVolumeIsAcceptedAgainWhateverTheVolume) {
  for (const VolumeFacts& facts :
       {with_values(-kLargestFloat, kLargestFloat), with_values(-kLargest, kLargest),
        with_values(-kLargestFloat, 1000.0), with_values(5.0, 5.0), with_values(0.0, 1e-45),
        with_values(std::nan(""), std::nan("")), with_values(-kLargest, std::nan("")),
        of_size(1e-6), of_size(1e-9), of_size(1e3)}) {
    for (const char* projection : {"perspective", "orthographic"}) {
      const Json document{{"camera", {{"projection", projection}}}};
      const Json complete = scene_document(resolve_scene(document, facts, {640, 480}));
      EXPECT_NO_THROW(validate(complete, "scene")) << complete.dump(1);
      EXPECT_EQ(scene_document(resolve_scene(complete, facts, {640, 480})), complete);
      EXPECT_NO_THROW(patch_scene_document(complete, {{"lens", {{"strength", 0.5}}}}));
    }
  }
}

TEST(Admitted, ChangesNothingWithinTheLimits) {
  const Json complete = scene_document(resolve_scene(Json::object(), ball_facts(), {640, 480}));
  EXPECT_EQ(admitted(complete, "scene"), complete);
}

TEST(Admitted, BringsEachNumberToItsNearestLimit) {
  const Json given{{"lens", {{"radius_mm", 1e9}, {"centre_mm", {-1e9, 0.0, std::nan("")}}}},
                   {"slices", {{"window", {{"width", 0.0}}}}}};
  const Json expected{{"lens", {{"radius_mm", 2000.0}, {"centre_mm", {-100000.0, 0.0, -100000.0}}}},
                      {"slices", {{"window", {{"width", 1e-30}}}}}};
  EXPECT_EQ(admitted(given, "scene"), expected);
}

}  // namespace
}  // namespace cutaway
