// What is said per mille of the height looks the same in a small picture and in one four times as
// high.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

constexpr int kTimes = 4;
constexpr Viewport kSmall{480, 360};
constexpr Viewport kLarge{kTimes * 480, kTimes * 360};

const std::shared_ptr<const LoadedVolume>& head() {
  static const auto volume = load(make_phantom({PhantomKind::head, 128}, {}, {}));
  return volume;
}

BytePicture draw(const Json& document, Viewport viewport, int rays) {
  const Scene scene = scene_for(document, head(), viewport);
  RenderSettings settings = settings_for(scene);
  settings.supersampling = rays;
  return GpuHarness::instance().render(scene, head(), settings);
}

/// The larger picture at the smaller one's size.
BytePicture reduced(const BytePicture& large) {
  BytePicture small{large.size_px / kTimes, {}};
  for (int y = 0; y < small.size_px.y; ++y) {
    for (int x = 0; x < small.size_px.x; ++x) {
      glm::ivec3 sum(0);
      for (int i = 0; i < kTimes * kTimes; ++i)
        sum += large.rgb(kTimes * glm::ivec2(x, y) + glm::ivec2(i % kTimes, i / kTimes));
      for (int c = 0; c < 3; ++c)
        small.rgba.push_back(static_cast<std::uint8_t>(sum[c] / (kTimes * kTimes)));
      small.rgba.push_back(255);
    }
  }
  return small;
}

/// Per channel, of the pixels that are not background in both.
double difference(const BytePicture& one, const BytePicture& other) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < one.size_px.y; ++y) {
    for (int x = 0; x < one.size_px.x; ++x) {
      const glm::ivec3 a = one.rgb({x, y});
      const glm::ivec3 b = other.rgb({x, y});
      if (a == glm::ivec3(0) || b == glm::ivec3(0)) continue;
      for (int c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]) / 3.0;
      ++count;
    }
  }
  return sum / std::max(count, 1);
}

Json scene_with(const Json& context, const Json& focus) {
  return {{"background", {{"colour", {0, 0, 0}}}},
          {"context",
           {{"shading", {{"name", "tone"}, {"detail", 0}, {"softness_per_mille", 2}}},
            {"filters", context}}},
          {"focus", {{"filters", focus}}}};
}

TEST(AnySize, LooksTheSame) {
  const Json lines = {{"name", "depth_lines"}, {"width_per_mille", 5}};
  const std::pair<const char*, Json> styles[] = {
      {"kuwahara", scene_with({{{"name", "kuwahara"}, {"radius_per_mille", 8}}}, Json::array())},
      {"brush",
       scene_with({{{"name", "anisotropic_kuwahara"}, {"radius_per_mille", 10}}}, Json::array())},
      {"depth_lines", scene_with({lines}, {lines})},
      {"dog", scene_with({{{"name", "dog"}, {"sigma_per_mille", 3}}}, Json::array())},
      {"xdog", scene_with({{{"name", "xdog"}, {"sigma_per_mille", 3}}}, Json::array())},
      {"fdog", scene_with({{{"name", "fdog"}, {"sigma_per_mille", 3}, {"length_per_mille", 8}}},
                          Json::array())}};
  for (const auto& [name, document] : styles) {
    const double found = difference(draw(document, kSmall, 2), reduced(draw(document, kLarge, 1)));
    std::printf("%s: %.2f/255\n", name, found);
    EXPECT_LE(found, 6.0) << name;
  }
}

/// How much of the picture is pure ink.
double share_of_ink(const BytePicture& picture) {
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    sum +=
        picture.rgba[i] > 250 && picture.rgba[i + 1] < 5 && picture.rgba[i + 2] > 250 ? 1.0 : 0.0;
  return sum / static_cast<double>(picture.rgba.size() / 4);
}

TEST(AnySize, HasLinesOfOneWidthForTheHeight) {
  const Json lines = {
      {"name", "depth_lines"}, {"width_per_mille", 11}, {"thinnest", 1}, {"colour", {1, 0, 1}}};
  const Json document = scene_with({lines}, Json::array());
  const double small = share_of_ink(draw(document, kSmall, 1));
  const double large = share_of_ink(draw(document, kLarge, 1));
  EXPECT_GT(small, 0.005);
  EXPECT_NEAR(small / large, 1.0, 0.15);
}

}  // namespace
}  // namespace cutaway::test
