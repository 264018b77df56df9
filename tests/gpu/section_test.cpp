// A cut in the colours of tissue is the slice through the same plane in the same colours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/tissue_ramp.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

constexpr Viewport kSectionViewport{160, 120};
constexpr double kPlane_mm = -20.0;
constexpr double kHeight_mm = 150.0;

/// Greys of one Hounsfield unit each, and ends that say nothing.
constexpr double kWindow = 255.0;

/// A box that is open to the viewer, whose far side lies in a coronal plane.
Json cut_open() {
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {0, -600, 0}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"view_height_mm", kHeight_mm}}},
          {"light", {{"frame", "patient"}, {"direction", {0, -1, 0}}}},
          {"context", {{"surface", {{"iso_value", -200}}}, {"filters", Json::array()}}},
          {"focus", {{"surface", {{"iso_value", 1e5}}}, {"filters", Json::array()}}},
          {"lens",
           {{"cap", "section"},
            {"centre_mm", {0, kPlane_mm - 200.0, 0}},
            {"radius_mm", 200},
            {"shape", {{"name", "box"}, {"width", 1}, {"height", 1}, {"depth", 1}}}}},
          {"slices",
           {{"crosshair_mm", {0, kPlane_mm, 0}},
            {"coronal", {{"centre_mm", {0, kPlane_mm, 0}}, {"view_height_mm", kHeight_mm}}}}}};
}

/// The values that slices of as many windows as it takes tell.
std::vector<double> slice_values(const std::shared_ptr<const LoadedVolume>& volume) {
  Viewport viewport = kSectionViewport;
  viewport.kind = ViewKind::coronal;
  std::vector<double> values(std::size_t(viewport.width_px) * viewport.height_px, -1e9);
  for (double centre = -300.0; centre < 2500.0; centre += 200.0) {
    Json document = cut_open();
    document["slices"]["window"] = {{"centre", centre}, {"width", kWindow}};
    const Scene scene = scene_for(document, volume, viewport);
    const BytePicture slice = GpuHarness::instance().render(scene, volume, settings_for(scene));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int grey = slice.rgba[4 * i];
      if (grey > 20 && grey < 235) values[i] = centre + grey - 0.5 * kWindow;
    }
  }
  return values;
}

glm::dvec3 in_ramp(const TissueRamp& ramp, double value) {
  const double share = (value - ramp.range.minimum) / (ramp.range.maximum - ramp.range.minimum);
  const double at = std::clamp(share, 0.0, 1.0) * (kTissueColours - 1);
  const int below = std::min(int(at), kTissueColours - 2);
  return glm::mix(glm::dvec3(ramp.colours[below]), glm::dvec3(ramp.colours[below + 1]), at - below);
}

TEST(Section, OfACutIsTheSliceInTheColoursOfTissue) {
  const auto volume = load(make_phantom({PhantomKind::head, 96}, {}, {}));
  const Scene scene = scene_for(cut_open(), volume, kSectionViewport);
  const BytePicture section = GpuHarness::instance().render(scene, volume, settings_for(scene));
  const auto surface = FramePipeline::read_surface(GpuHarness::instance().view(), kContext);
  const std::vector<double> values = slice_values(volume);
  const TissueRamp ramp = tissue_ramp(*volume);
  double sum = 0.0;
  double most = 0.0;
  int compared = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_cut = glm::length(glm::vec3(surface[i])) > 3.5F;
    if (!is_cut || values[i] < -1e8) continue;
    const glm::dvec3 expected = 255.0 * in_ramp(ramp, values[i]);
    for (int channel = 0; channel < 3; ++channel) {
      const double apart = std::abs(section.rgba[4 * i + channel] - expected[channel]);
      sum += apart / 3.0;
      most = std::max(most, apart);
    }
    ++compared;
  }
  std::printf("cut against slice: mean %.3f/255, most %.2f/255 of %d pixels\n", sum / compared,
              most, compared);
  EXPECT_GT(compared, 3000);
  EXPECT_LE(sum / compared, 1.0);
  EXPECT_LE(most, 2.0);  // half a grey of the slice's, half a step of the section's
}

}  // namespace
}  // namespace cutaway::test
