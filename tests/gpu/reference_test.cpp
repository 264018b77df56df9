// GPU pictures against the CPU reference: every geometry a file can have, both projections, each
// lens cap.
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"
#include "volume/voxel_packing.h"

namespace cutaway::test {
namespace {

constexpr Viewport kComparedViewport{160, 120};

Json flagship() {
  return Json::parse(R"({
    "focus": {"shading": {"name": "tone", "detail": 1}, "filters": [{"name": "sobel"}]},
    "context": {"shading": {"name": "tone", "detail": 0, "dark": [0.62, 0.5, 0.44], "light": [0.74, 0.61, 0.54]},
                "filters": [{"name": "kuwahara"}]},
    "lens": {"centre_mm": [-10, -40, 5], "radius_mm": 28}})");
}

/// The lens where the defaults put it: on the volume's own front.
Json flagship_placed_by_default() {
  Json document = flagship();
  document.erase("lens");
  return document;
}

struct Grid {
  const char* name;
  glm::dvec3 spacing_mm;
  glm::dmat3 direction;
};

class EveryGeometry : public testing::TestWithParam<Grid> {};

TEST_P(EveryGeometry, LooksLikeTheReference) {
  const Grid& grid = GetParam();
  const glm::ivec3 size(100.0 / grid.spacing_mm);
  const auto volume = load(shells_volume(centred_geometry(size, grid.spacing_mm, grid.direction)));
  const Scene scene = scene_for(flagship(), volume, kComparedViewport);
  expect_like_reference(std::string("geometry-") + grid.name, scene, volume, settings_for(scene),
                        tolerance_for(scene));
}

TEST_P(EveryGeometry, OfTranslucentBandsLooksLikeTheReference) {
  const Grid& grid = GetParam();
  const glm::ivec3 size(100.0 / grid.spacing_mm);
  const auto volume = load(shells_volume(centred_geometry(size, grid.spacing_mm, grid.direction)));
  Json document = flagship();
  document["context"]["surface"] = {{"iso_value", -200}, {"upper_value", 0}, {"opacity", 0.08}};
  document["focus"]["surface"] = {{"iso_value", 250}, {"opacity", 0.3}};
  document["context"]["shading"] = {{"name", "gooch"}};
  document["focus"]["filters"] = {{{"name", "sobel"}, {"source", "depth"}, {"norm", "unit"}}};
  const Scene scene = scene_for(document, volume, kComparedViewport);
  expect_like_reference(std::string("translucent-") + grid.name, scene, volume, settings_for(scene),
                        tolerance_for(scene));
}

TEST_P(EveryGeometry, UnderTheMagicLensLooksLikeTheReference) {
  const Grid& grid = GetParam();
  const glm::ivec3 size(100.0 / grid.spacing_mm);
  const auto volume = load(shells_volume(centred_geometry(size, grid.spacing_mm, grid.direction)));
  Json document = flagship();
  document["lens"]["mode"] = "magic";
  const Scene scene = scene_for(document, volume, kComparedViewport);
  expect_like_reference(std::string("magic-") + grid.name, scene, volume, settings_for(scene),
                        tolerance_for(scene));
}

INSTANTIATE_TEST_SUITE_P(
    Reference, EveryGeometry,
    testing::Values(Grid{"isotropic", glm::dvec3(1.0), glm::dmat3(1.0)},
                    Grid{"anisotropic", kAnisotropicSpacingMm, glm::dmat3(1.0)},
                    Grid{"oblique", glm::dvec3(1.0), oblique_direction()},
                    Grid{"flipped", glm::dvec3(1.0), flipped_direction()},
                    Grid{"anisotropic_oblique", kAnisotropicSpacingMm, oblique_direction()},
                    Grid{"anisotropic_flipped", kAnisotropicSpacingMm, flipped_direction()}),
    [](const auto& parameter) { return parameter.param.name; });

class EveryPhantom : public testing::TestWithParam<PhantomKind> {};

TEST_P(EveryPhantom, LooksLikeTheReference) {
  const auto volume = load(make_phantom({GetParam(), 64}, {}, {}));
  const Scene scene = scene_for(flagship_placed_by_default(), volume, kComparedViewport);
  expect_like_reference("phantom-" + std::to_string(static_cast<int>(GetParam())), scene, volume,
                        settings_for(scene), tolerance_for(scene));
}

INSTANTIATE_TEST_SUITE_P(Reference, EveryPhantom,
                         testing::Values(PhantomKind::head, PhantomKind::abdomen,
                                         PhantomKind::knees));

TEST(Reference, OrthographicViewFromTheSideWithEachCap) {
  const auto volume = load(shells_volume(centred_geometry({90, 90, 45}, {1.0, 1.0, 2.0})));
  for (const char* cap : {"flat", "gradient", "open"}) {
    Json document = flagship();
    document["lens"]["cap"] = cap;
    document["lens"]["centre_mm"] = {25, 0, 10};
    document["camera"] = {{"projection", "orthographic"},
                          {"eye_mm", {300, 40, 20}},
                          {"target_mm", {0, 0, 0}},
                          {"up", {0, 0.2, 1}},
                          {"view_height_mm", 100}};
    const Scene scene = scene_for(document, volume, kComparedViewport);
    expect_like_reference(std::string("cap-") + cap, scene, volume, settings_for(scene),
                          tolerance_for(scene));
  }
}

TEST(Reference, EyeInsideTheBoneAndInsideTheLens) {
  const auto volume = load(shells_volume(centred_geometry({90, 90, 90}, glm::dvec3(1.0))));
  for (const double y : {-15.0, -35.0, -44.0}) {
    Json document = flagship();
    document["camera"] = {{"eye_mm", {0, y, 0}},
                          {"target_mm", {3, 60, 2}},
                          {"up", {0, 0, 1}},
                          {"vertical_fov_degrees", 90}};
    const Scene scene = scene_for(document, volume, kComparedViewport);
    expect_like_reference("eye-at-" + std::to_string(static_cast<int>(y)), scene, volume,
                          settings_for(scene), tolerance_for(scene));
  }
}

TEST(Reference, TissueThatTheBoxCutsShowsAFlatFace) {
  const auto volume = load(sphere_volume(centred_geometry({60, 40, 60}, glm::dvec3(1.0)), 40.0));
  Json document = flagship();
  document["context"]["surface"]["iso_value"] = 5.0;
  document["focus"]["surface"]["iso_value"] = 15.0;
  document["camera"] = {{"eye_mm", {60, -200, 50}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}};
  const Scene scene = scene_for(document, volume, kComparedViewport);
  expect_like_reference("box-face", scene, volume, settings_for(scene), tolerance_for(scene));
}

BytePicture picture_of(const Json& document, Volume volume) {
  const auto loaded = load(std::move(volume));
  const Scene scene = scene_for(document, loaded, kComparedViewport);
  return GpuHarness::instance().render(scene, loaded, settings_for(scene));
}

/// The shells in 16 bits, as a file of that slope stores them.
Volume shells_with_slope(int slope) {
  Volume volume = shells_volume(centred_geometry({90, 90, 45}, {1.0, 1.0, 2.0}));
  std::vector<std::int16_t> stored;
  for (const float hu : std::get<std::vector<float>>(volume.voxels)) {
    stored.push_back(static_cast<std::int16_t>(slope * static_cast<int>(hu)));
  }
  PackedVoxels packed = pack_voxels(std::span<const std::int16_t>(stored), slope, 0.0);
  volume.voxels = std::move(packed.voxels);
  volume.value_scale = packed.value_scale;
  volume.value_offset = packed.value_offset;
  volume.value_range = packed.value_range;
  return volume;
}

TEST(Reference, TheSignOfTheRescaleDoesNotShow) {
  const BytePicture plain = picture_of(flagship(), shells_with_slope(1));
  EXPECT_EQ(picture_of(flagship(), shells_with_slope(-1)).rgba, plain.rgba);
  const auto negative = load(shells_with_slope(-1));
  const Scene scene = scene_for(flagship(), negative, kComparedViewport);
  expect_like_reference("negative-slope", scene, negative, settings_for(scene),
                        tolerance_for(scene));
}

/// Values that no Hounsfield scale knows: the picture is that of the same values in a usual range.
TEST(Reference, ValuesFarFromOneLookAsOthersDo) {
  const auto picture = [](double factor) {
    const auto volume = sampled_volume(
        centred_geometry(60), [factor](glm::dvec3 x) { return factor * (64.0 - glm::length(x)); });
    Json document = flagship();
    document["context"]["surface"]["iso_value"] = factor * 36.0;
    document["focus"]["surface"]["iso_value"] = factor * 46.0;
    return picture_of(document, volume);
  };
  const BytePicture usual = picture(1.0);
  EXPECT_EQ(picture(std::exp2(100)).rgba, usual.rgba);
  EXPECT_EQ(picture(std::exp2(-60)).rgba, usual.rgba);
}

TEST(Reference, SupersampledStillAndReducedPicture) {
  const auto volume = load(make_phantom({PhantomKind::head, 64}, {}, {}));
  const Scene scene = scene_for(flagship(), volume, kComparedViewport);
  RenderSettings still = settings_for(scene);
  still.supersampling = 2;
  expect_like_reference("supersampled", scene, volume, still, tolerance_for(scene));
  RenderSettings reduced = settings_for(scene);
  reduced.resolution_scale = 0.5;
  reduced.picture_size_px /= 2;
  expect_like_reference("reduced", scene, volume, reduced, tolerance_for(scene));
}

}  // namespace
}  // namespace cutaway::test
