// The planes for JPEG against ITU-T T.871, in every layout and at odd sizes, and through the codec.
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cmath>

#include "encode/jpeg.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

struct Converted {
  BytePicture picture;
  Picture planes;
};

Converted convert(PixelLayout layout, Viewport size) {
  const auto volume = load(shells_volume(centred_geometry(64)));
  const Scene scene =
      scene_for({{"lens", {{"centre_mm", {0, -40, 0}}, {"radius_mm", 20}}}}, volume, size);
  GpuHarness& gpu = GpuHarness::instance();
  Converted result{gpu.render(scene, volume, settings_for(scene)), {}};
  RenderSettings settings = settings_for(scene);
  settings.layout = layout;
  GpuVolume gpu_volume(volume, 2048);
  gpu_volume.upload_rest();
  gpu.pipeline().render(gpu.view(), scene, gpu_volume, settings);
  gl::PixelReadback readback;
  FramePipeline::start_readback(gpu.view(), layout, readback);
  result.planes = {layout, settings.picture_size_px, readback.finish()};
  return result;
}

glm::dvec3 mean_rgb(const BytePicture& picture, glm::ivec2 block, int block_px) {
  glm::dvec3 sum(0.0);
  for (int i = 0; i < block_px * block_px; ++i) {
    const glm::ivec2 at = block * block_px + glm::ivec2(i % block_px, i / block_px);
    sum += glm::dvec3(picture.rgb(glm::min(at, picture.size_px - 1)));
  }
  return sum / static_cast<double>(block_px * block_px);
}

class Layouts : public testing::TestWithParam<std::tuple<PixelLayout, Viewport>> {};

TEST_P(Layouts, ArePlanesOfT871) {
  const auto [layout, size] = GetParam();
  const Converted converted = convert(layout, size);
  const int block_px = layout == PixelLayout::yuv420 ? 2 : 1;
  const glm::ivec2 chroma((size.width_px + block_px - 1) / block_px,
                          (size.height_px + block_px - 1) / block_px);
  ASSERT_EQ(converted.planes.planes().size(), 3U);
  ASSERT_EQ(converted.planes.plane(1).size_px(), chroma);
  const auto at = [&](std::size_t plane, int x, int y) {
    return converted.planes.plane(plane).row(y)[static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < chroma.y; ++y) {
    for (int x = 0; x < chroma.x; ++x) {
      const glm::dvec3 rgb = mean_rgb(converted.picture, {x, y}, block_px);
      const double luma = glm::dot(rgb, glm::dvec3(0.299, 0.587, 0.114));
      EXPECT_NEAR(at(1, x, y), 128.0 + (rgb.b - luma) / 1.772, 1.01);
      EXPECT_NEAR(at(2, x, y), 128.0 + (rgb.r - luma) / 1.402, 1.01);
    }
  }
  ASSERT_EQ(converted.planes.plane(0).size_px(), chroma * block_px);
  for (int y = 0; y < size.height_px; ++y) {
    for (int x = 0; x < size.width_px; ++x) {
      const double luma =
          glm::dot(glm::dvec3(converted.picture.rgb({x, y})), glm::dvec3(0.299, 0.587, 0.114));
      EXPECT_NEAR(at(0, x, y), luma, 1.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Conversion, Layouts,
                         testing::Combine(testing::Values(PixelLayout::yuv420, PixelLayout::yuv444),
                                          testing::Values(Viewport{64, 48}, Viewport{61, 37},
                                                          Viewport{1, 1})));

TEST(Conversion, TheCodecGivesThePictureBack) {
  for (const PixelLayout layout : {PixelLayout::yuv420, PixelLayout::yuv444}) {
    const Converted converted = convert(layout, {61, 37});
    const auto jpeg = encode_jpeg(converted.planes, 95).bytes;
    BytePicture decoded{{61, 37}, std::vector<std::uint8_t>(61UL * 37 * 4)};
    const tjhandle decoder = tjInitDecompress();
    ASSERT_EQ(tjDecompress2(decoder, jpeg.data(), jpeg.size(), decoded.rgba.data(), 61, 0, 37,
                            TJPF_RGBA, 0),
              0);
    tjDestroy(decoder);
    // Halved chroma bleeds over the hard edges of so small a picture.
    const double allowed = layout == PixelLayout::yuv420 ? 8.0 : 2.0;
    EXPECT_LT(compare(decoded, converted.picture).mean, allowed);
  }
}

}  // namespace
}  // namespace cutaway::test
