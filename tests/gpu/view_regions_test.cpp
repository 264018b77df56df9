// Where a branch can be in the picture: no point of the volume or of the lens may fall outside.
#include "render/view_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr glm::ivec2 kPicture{150, 75};  // half of the viewport each way

bool contains(const gl::PixelRect& region, glm::dvec2 at) {
  return at.x >= region.begin.x && at.x <= region.end.x && at.y >= region.begin.y &&
         at.y <= region.end.y;
}

class Views : public testing::Test {
 protected:
  Views() : volume_(load(shells_volume(centred_geometry(32)))) {}

  Scene scene(const char* projection, glm::dvec3 eye_mm, glm::dvec3 lens_mm) const {
    const Json document = {
        {"camera",
         {{"projection", projection},
          {"eye_mm", {eye_mm.x, eye_mm.y, eye_mm.z}},
          {"target_mm", {3, 5, 2}},
          {"up", {0.1, 0, 1}},
          {"view_height_mm", 60}}},
        {"lens", {{"centre_mm", {lens_mm.x, lens_mm.y, lens_mm.z}}, {"radius_mm", 12}}}};
    return scene_for(document, volume_, {300, 150});
  }

  glm::dvec3 in_cube() {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    return {unit(random_), unit(random_), unit(random_)};
  }

  ViewRegions regions(const Scene& scene) const {
    return view_regions(scene, volume_->volume.geometry, {.picture_size_px = kPicture});
  }

  std::shared_ptr<const LoadedVolume> volume_;
  std::mt19937 random_{5};
};

TEST_F(Views, HoldEveryPointThatIsInThePicture) {
  const VolumeGeometry& geometry = volume_->volume.geometry;
  const glm::dmat4 to_patient = index_to_patient(geometry);
  const glm::dvec3 half = 0.5 * glm::dvec3(geometry.size_voxels - 1);
  int looked_at = 0;
  for (int round = 0; round < 200; ++round) {
    const Scene view = scene(round % 2 == 0 ? "perspective" : "orthographic",
                             170.0 * in_cube() + glm::dvec3(0, 0, 5), 25.0 * in_cube());
    const ViewRegions found = regions(view);
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 in_volume(to_patient * glm::dvec4(half + half * in_cube(), 1.0));
      const auto at = project_px(view.camera, view.viewport, in_volume);
      const glm::dvec2 pixel = at ? *at * 0.5 : glm::dvec2(-1.0);
      if (!contains({{0, 0}, kPicture}, pixel)) continue;
      ++looked_at;
      ASSERT_TRUE(contains(found.volume, pixel)) << round;
      const bool in_lens = glm::distance(in_volume, view.lens.centre_mm) < view.lens.radius_mm;
      ASSERT_TRUE(!in_lens || contains(found.branches[kFocus], pixel)) << round;
    }
  }
  EXPECT_GT(looked_at, 2000);
}

TEST_F(Views, OfASmallLensAreSmall) {
  const ViewRegions found = regions(scene("orthographic", {0, -200, 0}, {0, 0, 0}));
  const glm::ivec2 size = found.branches[kFocus].end - found.branches[kFocus].begin;
  EXPECT_LE(size.x, 12 * 2 * 75 / 60 + 6);  // its diameter at 75 pixels to 60 mm, and the margins
  EXPECT_GT(size.x, 12 * 2 * 75 / 60);
  EXPECT_EQ(found.branches[kContext], found.volume);
}

TEST_F(Views, WithoutALensHaveNoFocus) {
  Scene view = scene("perspective", {0, -200, 0}, {0, 0, 0});
  view.lens.mode = LensMode::none;
  EXPECT_TRUE(regions(view).branches[kFocus].is_empty());
}

TEST_F(Views, FromInsideTheVolumeAreTheWholePicture) {
  const gl::PixelRect whole{{0, 0}, kPicture};
  EXPECT_EQ(regions(scene("perspective", {1, 2, 3}, {0, 0, 0})).volume, whole);
}

TEST(PixelRects, PartsAroundAHoleCoverTheRestOnce) {
  const gl::PixelRect outer{{3, 2}, {13, 9}};
  const std::vector<gl::PixelRect> holes = {
      {{5, 4}, {8, 6}},   {{0, 0}, {5, 5}},   {{10, 0}, {20, 20}}, {{4, 2}, {6, 9}},
      {{0, 0}, {20, 20}}, {{14, 3}, {18, 6}}, {{6, 6}, {6, 6}}};
  for (const gl::PixelRect& hole : holes) {
    const auto parts = parts_around(outer, hole);
    EXPECT_LE(parts.size(), 4U);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        const auto holds = [&](const gl::PixelRect& rect) {
          return x >= rect.begin.x && x < rect.end.x && y >= rect.begin.y && y < rect.end.y;
        };
        EXPECT_EQ(std::ranges::count_if(parts, holds), holds(outer) && !holds(hole) ? 1 : 0);
      }
    }
  }
}

}  // namespace
}  // namespace cutaway::test
