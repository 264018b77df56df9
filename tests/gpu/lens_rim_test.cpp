// The border that a lens cuts is no outline of the anatomy: no line may be drawn along it, all the
// way round.
#include <gtest/gtest.h>

#include "scene/styles.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

constexpr int kRays = 2;  ///< a pixel each way, as stills have
constexpr glm::ivec2 kSize{240, 200};

/// How many of a pixel's rays a branch holds in the view that was drawn last.
class Held {
 public:
  explicit Held(BranchIndex branch)
      : surface_(FramePipeline::read_surface(GpuHarness::instance().view(), branch)) {}

  int rays(glm::ivec2 pixel) const {
    int held = 0;
    for (int i = 0; i < kRays * kRays; ++i) {
      const glm::ivec2 at = pixel * kRays + glm::ivec2(i % kRays, i / kRays);
      held += surface_[static_cast<std::size_t>(at.y) * kSize.x * kRays + at.x].w >= 0.0F ? 1 : 0;
    }
    return held;
  }

  bool all_round(glm::ivec2 pixel, int reach) const {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        if (rays(pixel + glm::ivec2(x, y)) < kRays * kRays) return false;
      }
    }
    return true;
  }

 private:
  std::vector<glm::vec4> surface_;
};

struct RenderedRim {
  BytePicture picture;
  Held focus;
  Held context;
};

RenderedRim render(const Json& document, const std::shared_ptr<const LoadedVolume>& volume) {
  const Scene scene = scene_for(document, volume, {kSize.x, kSize.y});
  RenderSettings settings = settings_for(scene);
  settings.supersampling = kRays;
  BytePicture picture = GpuHarness::instance().render(scene, volume, settings);
  return {std::move(picture), Held(kFocus), Held(kContext)};
}

/// What silhouettes draw, pixel by pixel: where the branch goes on all round in the anatomy, and
/// where it ends.
struct Lines {
  int rim = 0;          ///< pixels of the branch beside which it ends though the anatomy goes on
  int along_rim = 0;    ///< pixels that got darker where the anatomy goes on
  int at_outlines = 0;  ///< the others that got darker
};

Lines lines_of(const BytePicture& with_lines, const BytePicture& without, const Held& held,
               const Held& anatomy) {
  Lines lines;
  for (int y = 3; y < kSize.y - 3; ++y) {
    for (int x = 3; x < kSize.x - 3; ++x) {
      const glm::ivec2 pixel(x, y);
      const bool goes_on = anatomy.all_round(pixel, 2);
      const bool is_darker = glm::any(glm::lessThan(with_lines.rgb(pixel), without.rgb(pixel)));
      if (is_darker) ++(goes_on ? lines.along_rim : lines.at_outlines);
      if (goes_on && held.rays(pixel) > 0 && !held.all_round(pixel, 1)) ++lines.rim;
    }
  }
  return lines;
}

const std::shared_ptr<const LoadedVolume>& head() {
  static const auto volume = load(make_phantom({PhantomKind::head, 128}, {}, {}));
  return volume;
}

/// The style with its lines, with or without silhouettes.
Json dissertation(bool silhouettes, glm::dvec3 lens_mm, double radius_mm) {
  Json document = style("dissertation").scene;
  for (Json& filter : document["focus"]["filters"]) {
    if (filter.at("name") == "sobel") filter["silhouettes"] = silhouettes;
  }
  document["lens"]["centre_mm"] = {lens_mm.x, lens_mm.y, lens_mm.z};
  document["lens"]["radius_mm"] = radius_mm;
  return document;
}

TEST(LensRim, OfTheDissertationsFocusHasNoLineWhereTheFocusGoesOn) {
  const Lens placed = scene_for(style("dissertation").scene, head(), {kSize.x, kSize.y}).lens;
  for (const double factor : {0.6, 0.8, 1.0}) {
    const double radius_mm = factor * placed.radius_mm;
    const RenderedRim on = render(dissertation(true, placed.centre_mm, radius_mm), head());
    const RenderedRim off = render(dissertation(false, placed.centre_mm, radius_mm), head());
    // Four pixels larger: where it holds the focus all round a pixel, the anatomy has no border.
    const RenderedRim larger =
        render(dissertation(true, placed.centre_mm, radius_mm + 4.0), head());
    const Lines lines = lines_of(on.picture, off.picture, on.focus, larger.focus);
    EXPECT_EQ(lines.along_rim, 0) << radius_mm;
    EXPECT_GT(lines.rim, 50) << radius_mm;
    EXPECT_GT(lines.at_outlines, 50) << radius_mm;
  }
}

/// A ball as context, and a lens over its limb that holds nothing.
Json bitten_ball(bool silhouettes, const char* lens_mode, double lens_y_mm) {
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {0, -200, 0}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"view_height_mm", 100}}},
          {"context",
           {{"surface", {{"iso_value", 0}}},
            {"filters", {{{"name", "sobel"}, {"silhouettes", silhouettes}}}}}},
          {"focus", {{"surface", {{"iso_value", 1000}}}}},
          {"background", {{"colour", {0.9, 0.9, 0.9}}}},
          {"lens", {{"mode", lens_mode}, {"centre_mm", {40, lens_y_mm, 0}}, {"radius_mm", 25}}}};
}

TEST(LensRim, OfTheContextHasNoLineAlongTheBiteThatTheLensTakesOfALimb) {
  const auto ball = load(sphere_volume(centred_geometry(96), 40.0));
  // In the plane of the limb the bite goes to the background; before it, to the cavity's wall.
  for (const double lens_y_mm : {0.0, -10.0}) {
    const RenderedRim on = render(bitten_ball(true, "cutaway", lens_y_mm), ball);
    const RenderedRim off = render(bitten_ball(false, "cutaway", lens_y_mm), ball);
    const RenderedRim whole = render(bitten_ball(true, "none", lens_y_mm), ball);
    const Lines lines = lines_of(on.picture, off.picture, on.context, whole.context);
    EXPECT_EQ(lines.along_rim, 0) << lens_y_mm;
    EXPECT_GT(lines.rim, 50) << lens_y_mm;
    EXPECT_GT(lines.at_outlines, 300) << lens_y_mm;
  }
}

/// Pixels where a line of `source` darkens by much more than the ball's and the cavity's own bend.
int dark_pixels(const char* source, const RenderedRim& plain, const std::vector<glm::ivec2>& pixels,
                const std::shared_ptr<const LoadedVolume>& ball) {
  Json document = bitten_ball(true, "cutaway", -10.0);
  document["context"]["filters"][0]["source"] = source;
  document["context"]["filters"][0]["depth_step_mm"] = 100.0;
  const BytePicture lines = render(document, ball).picture;
  return static_cast<int>(std::ranges::count_if(pixels, [&](glm::ivec2 pixel) {
    return plain.picture.rgb(pixel).r - lines.rgb(pixel).r > 60;
  }));
}

/// Whether the context is seen through the lens, by ray.
std::vector<bool> seen_through_lens() {
  std::vector<bool> result;
  for (const glm::vec4& surface :
       FramePipeline::read_surface(GpuHarness::instance().view(), kContext))
    result.push_back(glm::length(glm::vec3(surface)) > 1.5F);
  return result;
}

TEST(LensRim, OfTheContextHasNoLineOfAnySourceBetweenSkinAndCavity) {
  const auto ball = load(sphere_volume(centred_geometry(96), 40.0));
  Json document = bitten_ball(true, "cutaway", -10.0);
  document["context"]["filters"] = Json::array();
  const RenderedRim plain = render(document, ball);
  const std::vector<bool> through = seen_through_lens();
  std::vector<glm::ivec2> rim;
  for (int y = 5; y < kSize.y - 5; ++y) {
    for (int x = 5; x < kSize.x - 5; ++x) {
      const auto at = [&](int dx) {
        return through[y * kRays * kSize.x * kRays + (x + dx) * kRays];
      };
      if (plain.context.all_round({x, y}, 5) && at(0) != at(1)) rim.emplace_back(x, y);
    }
  }
  EXPECT_GT(rim.size(), 40);
  for (const char* source : {"colour", "luma", "depth", "normal"})
    EXPECT_EQ(dark_pixels(source, plain, rim, ball), 0) << source;
}

}  // namespace
}  // namespace cutaway::test
