#include "volume/phantoms.h"

#include <gtest/gtest.h>

namespace cutaway {
namespace {

Error::Detail refusal_of(std::string_view id) {
  try {
    parse_phantom_id(id);
  } catch (const Error& error) {
    return error.detail();
  }
  return {};
}

TEST(PhantomId, IsReadAndWritten) {
  EXPECT_EQ(parse_phantom_id("phantom:head")->size_voxels, 256);
  const auto request = parse_phantom_id("phantom:knees@64");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PhantomKind::knees);
  EXPECT_EQ(request->size_voxels, 64);
  for (const char* id :
       {"phantom:head", "phantom:abdomen", "phantom:knees@32", "phantom:head@512"}) {
    EXPECT_EQ(phantom_id(*parse_phantom_id(id)), id);
  }
  EXPECT_FALSE(parse_phantom_id("chest_ct"));
}

TEST(PhantomId, RefusesUnknownNamesAndSizes) {
  EXPECT_EQ(refusal_of("phantom:elbow").code, "unknown-volume");
  EXPECT_EQ(refusal_of("phantom:").code, "unknown-volume");
  for (const char* id : {"phantom:head@31", "phantom:head@513", "phantom:head@", "phantom:head@1e2",
                         "phantom:head@-64", "phantom:head@99999999999"}) {
    EXPECT_EQ(refusal_of(id).code, "out-of-range") << id;
    EXPECT_EQ(refusal_of(id).expected, "32 to 512 voxels an edge");
  }
  EXPECT_THROW(make_phantom({.size_voxels = 16}, {}, {}), Error);
}

class EveryPhantom : public testing::TestWithParam<PhantomKind> {};

TEST_P(EveryPhantom, IsTheSameWithOneThreadAndTwo) {
  const PhantomRequest request{.kind = GetParam(), .size_voxels = 40};
  EXPECT_EQ(make_phantom(request, {}, {}, 1).voxels, make_phantom(request, {}, {}, 2).voxels);
}

TEST_P(EveryPhantom, IsCentredIsotropicCtWithItsTrueRange) {
  const Volume volume = make_phantom({.kind = GetParam(), .size_voxels = 33}, {}, {});
  EXPECT_EQ(volume.description.modality, "CT");
  EXPECT_EQ(volume.description.units, "HU");
  const BoundingBox bounds = bounds_patient_mm(volume.geometry);
  EXPECT_NEAR(glm::length(bounds.minimum_mm + bounds.maximum_mm), 0.0, 1e-9);
  const auto& stored = std::get<std::vector<std::uint16_t>>(volume.voxels);
  const auto [lowest, highest] = std::minmax_element(stored.begin(), stored.end());
  EXPECT_EQ(volume.value_range, (ValueRange{*lowest - 1024.0, *highest - 1024.0}));
  EXPECT_LT(volume.value_range.minimum, -900.0);
  EXPECT_GT(volume.value_range.maximum, 500.0);
}

TEST_P(EveryPhantom, ReportsRisingProgressOfDecoding) {
  double last = 0.0;
  const auto sink = [&](LoadStage stage, double fraction) {
    EXPECT_EQ(stage, LoadStage::decode);
    EXPECT_GE(fraction, last);
    last = fraction;
  };
  make_phantom({.kind = GetParam(), .size_voxels = 48}, sink, {});
  EXPECT_EQ(last, 1.0);
}

TEST_P(EveryPhantom, CanBeCancelledOnTheWay) {
  std::stop_source source;
  double last = 0.0;
  const auto sink = [&](LoadStage, double fraction) {
    last = fraction;
    source.request_stop();
  };
  EXPECT_THROW(make_phantom({.kind = GetParam(), .size_voxels = 128}, sink, source.get_token()),
               Cancelled);
  EXPECT_LT(last, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Phantom, EveryPhantom,
                         testing::Values(PhantomKind::head, PhantomKind::abdomen,
                                         PhantomKind::knees));

}  // namespace
}  // namespace cutaway
