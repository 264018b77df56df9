// A tile is the same pixels as that part of the whole picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "render/stage_keys.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kViewport{230, 170};

struct TileCase {
  const char* name;
  const char* scene;
  ViewKind kind = ViewKind::volume;
};

class Tiles : public testing::TestWithParam<TileCase> {};

/// The largest difference of a channel between the tile's inner pixels and the whole picture's.
int largest_difference(const BytePicture& whole, const BytePicture& tile, glm::ivec2 begin_px,
                       int margin_px) {
  int largest = 0;
  for (int y = margin_px; y < tile.size_px.y - margin_px; ++y) {
    for (int x = margin_px; x < tile.size_px.x - margin_px; ++x) {
      const std::size_t here = 4 * (std::size_t(y) * tile.size_px.x + x);
      const std::size_t there =
          4 * (std::size_t(y + begin_px.y) * whole.size_px.x + x + begin_px.x);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        largest = std::max(
            largest, std::abs(int(tile.rgba[here + channel]) - int(whole.rgba[there + channel])));
      }
    }
  }
  return largest;
}

TEST_P(Tiles, AreThePictureThereOfTheWholeOne) {
  const auto volume = load(shells_volume(centred_geometry(64)));
  Viewport viewport = kViewport;
  viewport.kind = GetParam().kind;
  const Scene scene = scene_for(Json::parse(GetParam().scene), volume, viewport);
  RenderSettings settings = settings_for(scene);
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture whole = gpu.render(scene, volume, settings);
  const int margin_px = tile_margin_px(scene);
  for (const glm::ivec2 begin : {glm::ivec2(0, 0), {60, 35}, {110, 80}}) {
    settings.picture_size_px = {120, 90};
    settings.tile = PictureTile{begin, whole.size_px};
    const BytePicture tile = gpu.render(scene, volume, settings);
    EXPECT_EQ(largest_difference(whole, tile, begin, margin_px), 0);
  }
}

std::string tile_case_name(const testing::TestParamInfo<TileCase>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    OfEachKind, Tiles,
    testing::Values(TileCase{"flagship", "{}"},
                    TileCase{"orthographic", R"({"camera": {"projection": "orthographic"}})"},
                    TileCase{"magic", R"({"lens": {"mode": "magic"}})"},
                    TileCase{"wide_filter",
                             R"({"context": {"filters": [{"name": "kuwahara", "radius": 5}]}})"},
                    TileCase{"axial", "{}", ViewKind::axial}),
    tile_case_name);

}  // namespace
}  // namespace cutaway::test
