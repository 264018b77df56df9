// A picture drawn in parts is the whole one, in every layout.
#include "render/picture_parts.h"

#include <gtest/gtest.h>

#include "render/stage_keys.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr PartLimits kNoLimit{.bytes = std::uint64_t{1} << 40, .side_px = 16384};

std::shared_ptr<const LoadedVolume> shells() {
  static const auto volume = load(shells_volume(centred_geometry(64)));
  return volume;
}

Picture draw(const Scene& scene, const RenderSettings& settings, const PartLimits& limits,
             std::size_t* parts_drawn = nullptr) {
  GpuHarness& gpu = GpuHarness::instance();
  GpuVolume volume(shells(), gpu.context().max_3d_texture_size());
  volume.upload_rest();
  PictureParts parts(scene, settings, limits);
  ViewState view;
  for (std::size_t i = 0; i < parts.count(); ++i) {
    const RenderSettings part = parts.settings(i);
    gpu.pipeline().render(view, scene, volume, part);
    gl::PixelReadback readback;
    FramePipeline::start_readback(view, part.layout, readback);
    EXPECT_LE(view.bytes(), limits.bytes);
    parts.take(i, {part.layout, part.picture_size_px, readback.finish()});
  }
  if (parts_drawn != nullptr) *parts_drawn = parts.count();
  return parts.whole();
}

struct Case {
  const char* name;
  const char* scene;
  ViewKind kind = ViewKind::volume;
  int supersampling = 1;
};

class Parts : public testing::TestWithParam<std::tuple<Case, PixelLayout>> {
 protected:
  /// Odd sides, so that the last part's are odd, too.
  Scene scene(Viewport viewport = {333, 271}) const {
    const Case& drawn = std::get<0>(GetParam());
    viewport.kind = drawn.kind;
    return scene_for(Json::parse(drawn.scene), shells(), viewport);
  }
  RenderSettings settings(const Scene& scene) const {
    RenderSettings settings = settings_for(scene);
    settings.supersampling = std::get<0>(GetParam()).supersampling;
    settings.layout = std::get<1>(GetParam());
    return settings;
  }
};

TEST_P(Parts, MakeUpTheWholePictureByteForByte) {
  const Scene scene = this->scene();
  const RenderSettings settings = this->settings(scene);
  const Picture whole = draw(scene, settings, kNoLimit);
  std::size_t count = 0;
  const PartLimits limits{.bytes = bytes_for(needs_of(scene, settings)) * 2 / 3, .side_px = 16384};
  const Picture in_parts = draw(scene, settings, limits, &count);
  EXPECT_GT(count, 1U);
  for (std::size_t plane = 0; plane < whole.planes().size(); ++plane) {
    const auto expected = whole.plane(plane).bytes();
    const auto actual = in_parts.plane(plane).bytes();
    std::size_t differing = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) differing += expected[i] != actual[i] ? 1 : 0;
    EXPECT_EQ(differing, 0U) << "bytes of plane " << plane;
  }
}

TEST_P(Parts, NeedAsMuchAsIsSaid) {
  const Scene scene = this->scene();
  const RenderSettings settings = this->settings(scene);
  GpuHarness& gpu = GpuHarness::instance();
  GpuVolume volume(shells(), gpu.context().max_3d_texture_size());
  volume.upload_rest();
  ViewState view;
  gpu.pipeline().render(view, scene, volume, settings);
  EXPECT_EQ(view.bytes(), bytes_for(needs_of(scene, settings)));
}

std::string case_name(const testing::TestParamInfo<Parts::ParamType>& tested) {
  const char* layouts[] = {"yuv420", "yuv444", "rgba"};
  return std::string(std::get<0>(tested.param).name) + "_" +
         layouts[static_cast<int>(std::get<1>(tested.param))];
}

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, Parts,
    testing::Combine(
        testing::Values(
            Case{"flagship", "{}"}, Case{"supersampled", "{}", ViewKind::volume, 2},
            Case{"orthographic", R"({"camera": {"projection": "orthographic"}})"},
            Case{"magic", R"({"lens": {"mode": "magic"}})"},
            Case{"open_lens", R"({"lens": {"cap": "open", "radius_mm": 24}})"},
            Case{"translucent", R"({"context": {"surface": {"opacity": 0.4}}})"},
            Case{"wide_filter", R"({"context": {"filters": [{"name": "kuwahara", "radius": 5}]}})",
                 ViewKind::volume, 2},
            Case{"soft_step",
                 R"({"context": {"shading": {"name": "tone", "detail": 0, "softness": 3},
                                             "filters": []}})"},
            Case{"relative_lengths",
                 R"({"context": {"filters": [{"name": "kuwahara",
                                                          "radius_per_mille": 20}]}})"},
            Case{"brush",
                 R"({"context": {"filters": [{"name": "anisotropic_kuwahara",
                                                          "radius": 4}]}})"},
            Case{"lines",
                 R"({"context": {"filters": [{"name": "depth_lines", "width": 3},
                                                         {"name": "canny", "trail": 4}]},
                                 "focus": {"filters": [{"name": "xdog"}]}})"},
            Case{"hatching",
                 R"({"context": {"filters": [{"name": "hatching", "length": 20}]},
                                 "focus": {"filters": [{"name": "hatching",
                                                        "direction": "parallel"}]}})",
                 ViewKind::volume, 2},
            Case{"flow", R"({"context": {"filters": [{"name": "fdog"}]}})", ViewKind::volume, 2},
            Case{"axial", "{}", ViewKind::axial}, Case{"coronal", "{}", ViewKind::coronal, 2}),
        testing::Values(PixelLayout::yuv420, PixelLayout::yuv444, PixelLayout::rgba)),
    case_name);

TEST(PictureParts, AreOneWhereItIsWithinTheLimits) {
  const Scene scene = scene_for(Json::object(), shells(), {2560, 1440});
  const RenderSettings settings = settings_for(scene);
  const std::uint64_t bytes = bytes_for(needs_of(scene, settings));
  EXPECT_EQ(PictureParts(scene, settings, {bytes, 16384}).count(), 1U);
  EXPECT_GT(PictureParts(scene, settings, {bytes - 1, 16384}).count(), 1U);
}

TEST(PictureParts, AreNoLargerThanTheDevicesTextures) {
  const Scene scene = scene_for(Json::object(), shells(), {8192, 64});
  RenderSettings settings = settings_for(scene);
  settings.supersampling = 2;
  EXPECT_EQ(PictureParts(scene, settings, {kNoLimit.bytes, 32768}).count(), 1U);
  const PictureParts parts(scene, settings, {kNoLimit.bytes, 8192});
  EXPECT_GT(parts.count(), 1U);
  for (std::size_t i = 0; i < parts.count(); ++i)
    EXPECT_LE(longest_side_px(needs_of(scene, parts.settings(i))), 8192);
}

// A device with hardly any memory: they get no smaller than a few pixels, and end.
TEST(PictureParts, CoverThePictureHoweverSmallTheLimit) {
  const Scene scene = scene_for(Json::object(), shells(), {2049, 1});
  RenderSettings settings = settings_for(scene);
  settings.layout = PixelLayout::yuv420;
  PictureParts parts(scene, settings, {1, 1});
  EXPECT_GT(parts.count(), 1U);
  for (std::size_t i = 0; i < parts.count(); ++i) {
    const RenderSettings part = parts.settings(i);
    parts.take(i, Picture(part.layout, part.picture_size_px));
  }
  EXPECT_TRUE(parts.is_whole());
  EXPECT_EQ(parts.whole().size_px(), glm::ivec2(2049, 1));
}

TEST(PictureParts, TakeOnlyAPartOfItsSize) {
  const Scene scene = scene_for(Json::object(), shells(), {400, 300});
  PictureParts parts(scene, settings_for(scene), {1, 16384});
  Picture smaller(PixelLayout::rgba, parts.settings(0).picture_size_px - 1);
  EXPECT_DEATH(parts.take(0, std::move(smaller)), "a part comes as it was asked for");
}

}  // namespace
}  // namespace cutaway::test
