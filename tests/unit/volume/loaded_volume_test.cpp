#include "volume/loaded_volume.h"

#include <gtest/gtest.h>

#include "support/analytic_volumes.h"

namespace cutaway {
namespace {

TEST(DeriveLoadedVolume, HoldsWhatBelongsToTheVolume) {
  const Volume volume = test::sphere_volume(test::centred_geometry(40), 300.0);
  const auto loaded = derive_loaded_volume(volume, {}, {});
  EXPECT_EQ(loaded->volume.value_range, volume.value_range);
  EXPECT_EQ(loaded->min_max.size_bricks, glm::ivec3(10));
  EXPECT_EQ(loaded->histogram.range, volume.value_range);
  EXPECT_LT(loaded->findings.outer.value, loaded->findings.inner.value);
}

TEST(DeriveLoadedVolume, OfALargeVolumeHasLargerBricksAndNotMore) {
  const auto bricks = [](glm::ivec3 size) {
    return derive_loaded_volume(
               test::constant_volume(test::centred_geometry(size, glm::dvec3(1.0), glm::dmat3(1.0)),
                                     0.0),
               {}, {})
        ->min_max;
  };
  EXPECT_EQ(bricks({320, 4, 4}).brick_size, 4);
  EXPECT_EQ(bricks({321, 4, 4}).brick_size, 8);
}

TEST(DeriveLoadedVolume, ReportsRisingProgressToTheEnd) {
  double last = 0.0;
  const auto sink = [&](LoadStage stage, double fraction) {
    EXPECT_EQ(stage, LoadStage::min_max);
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  derive_loaded_volume(test::sphere_volume(test::centred_geometry(40), 0.0), sink, {});
  EXPECT_EQ(last, 1.0);
}

TEST(DeriveLoadedVolume, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  const Volume volume = test::sphere_volume(test::centred_geometry(40), 0.0);
  EXPECT_THROW(derive_loaded_volume(volume, {}, source.get_token()), Cancelled);
}

}  // namespace
}  // namespace cutaway
