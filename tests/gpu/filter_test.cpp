// Every filter on random pictures against the reference.
#include <gtest/gtest.h>

#include "support/filter_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;

TEST(Filters, AreTheReferencesOnRandomPictures) {
  const std::vector<Module> filters{kuwahara(0),
                                    kuwahara(1),
                                    kuwahara(3),
                                    kuwahara(7),
                                    sobel(0.7, "darken"),
                                    sobel(1.0, "brighten", "unit", "l2"),
                                    sobel(0.4, "multiply", "raw", "l2"),
                                    sobel(0.7, "darken", "unit", "l2", "luma", false),
                                    sobel(0.7, "darken", "unit", "l1", "depth"),
                                    sobel(0.7, "brighten", "unit", "l2", "depth", false),
                                    sobel(0.6, "darken", "unit", "l1", "normal", false)};
  for (const Module& module : filters) {
    for (const unsigned seed : {1U, 2U}) {
      const BranchImage input = random_picture(seed);
      const BranchImage actual = filtered_on_gpu(input, module);
      const BranchImage expected = reference::apply_filter(input, module, 1.0);
      for (std::size_t i = 0; i < input.pixels.size(); ++i) {
        if (expected.pixels[i].coverage == 0.0) continue;
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(actual.pixels[i].colour[c], expected.pixels[i].colour[c], 1.0 / 255.0)
              << module.name << module.parameters << " pixel " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cutaway::test
