// Every filter on random pictures against the reference.
#include <gtest/gtest.h>

#include "support/filter_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;

/// Of one pixel: places that follow the picture's edges are rounded to pixels, and rounding may
/// take the one beside.
double tolerance_of(const Module& filter) {
  // Its ways turn at a limit, too, and the noise on another way is other noise.
  if (filter.name == "hatching") return 64.0 / 255.0;
  const bool follows = filter.name == "anisotropic_kuwahara" || filter.name == "fdog";
  return follows ? 16.0 / 255.0 : 1.0 / 255.0;
}

TEST(Filters, AreTheReferencesOnRandomPictures) {
  const std::vector<Module> filters{
      kuwahara(0),
      kuwahara(1),
      kuwahara(3),
      kuwahara(7),
      sobel(0.7, "darken"),
      sobel(1.0, "brighten", "unit", "l2"),
      sobel(0.4, "multiply", "raw", "l2"),
      sobel(0.7, "darken", "unit", "l2", "luma", false),
      sobel(0.7, "darken", "unit", "l1", "depth"),
      sobel(0.7, "brighten", "unit", "l2", "depth", false),
      sobel(0.6, "darken", "unit", "l1", "normal", false),
      filter_module("anisotropic_kuwahara"),
      filter_module("anisotropic_kuwahara", {{"radius", 15}}),
      filter_module("anisotropic_kuwahara", {{"radius", 4}, {"anisotropy", 0}}),
      filter_module("anisotropic_kuwahara", {{"radius", 0.7}, {"sharpness", 2}}),
      filter_module("dog"),
      filter_module("dog", {{"sigma", 3}, {"tau", 0.95}}),
      filter_module("xdog"),
      filter_module("xdog", {{"sigma", 0.6}, {"edges", 3}}),
      filter_module("fdog"),
      filter_module("fdog", {{"sigma", 1.7}, {"length", 7}}),
      filter_module("canny", {{"high", 0.4}}),
      filter_module("luminance_quantisation"),
      filter_module("luminance_quantisation", {{"bins", 3}}),
      filter_module("hatching"),
      filter_module("hatching", {{"direction", "parallel"}, {"angle_degrees", 30}, {"wash", 0.4}}),
      filter_module("hatching", {{"width", 3.1}, {"length", 9}, {"cross_from", 0.2}}),
      filter_module("depth_lines"),
      filter_module("depth_lines",
                    {{"width", 5.5}, {"gap_mm", 6}, {"full_gap_mm", 30}, {"silhouettes", false}})};
  for (const Module& module : filters) {
    for (const unsigned seed : {1U, 2U}) {
      const BranchImage input = random_picture(seed);
      const BranchImage actual = filtered_on_gpu(input, module);
      const BranchImage expected = reference::apply_filter(input, module, 1.0);
      double sum = 0.0;
      for (std::size_t i = 0; i < input.pixels.size(); ++i) {
        if (expected.pixels[i].coverage == 0.0) continue;
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(actual.pixels[i].colour[c], expected.pixels[i].colour[c],
                      tolerance_of(module))
              << module.name << module.parameters << " pixel " << i;
          sum += std::abs(actual.pixels[i].colour[c] - expected.pixels[i].colour[c]);
        }
      }
      EXPECT_LE(sum / (3.0 * static_cast<double>(input.pixels.size())), 0.2 / 255.0)
          << module.name << module.parameters;
    }
  }
}

}  // namespace
}  // namespace cutaway::test
