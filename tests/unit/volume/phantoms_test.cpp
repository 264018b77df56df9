#include "volume/phantoms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  EXPECT_EQ(refusal_of("phantom:elbow").code, ErrorCode::unknown_volume);
  EXPECT_EQ(refusal_of("phantom:").code, ErrorCode::unknown_volume);
  for (const char* id : {"phantom:head@31", "phantom:head@513", "phantom:head@", "phantom:head@1e2",
                         "phantom:head@-64", "phantom:head@99999999999"}) {
    EXPECT_EQ(refusal_of(id).code, ErrorCode::out_of_range) << id;
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

/// FNV-1a over the stored values, low byte first.
std::uint64_t hash_of(const Volume& volume) {
  std::uint64_t hash = 14695981039346656037u;
  for (const std::uint16_t value : std::get<std::vector<std::uint16_t>>(volume.voxels)) {
    constexpr std::uint64_t kPrime = 1099511628211u;
    hash = (hash ^ (value & 0xffu)) * kPrime;
    hash = (hash ^ (unsigned(value) >> 8)) * kPrime;
  }
  return hash;
}

/// The same on every machine and in every build. To be changed only together with a phantom's look.
TEST(Phantoms, HaveTheBytesTheyHadBefore) {
  const auto hash = [](PhantomKind kind) {
    return hash_of(make_phantom({.kind = kind, .size_voxels = 64}, {}, {}));
  };
  EXPECT_EQ(hash(PhantomKind::head), 0xbc30ef734394ff56u);
  EXPECT_EQ(hash(PhantomKind::abdomen), 0x2926fdb429e4f6c1u);
  EXPECT_EQ(hash(PhantomKind::knees), 0x250f5db966a089a0u);
}

struct Landmark {
  PhantomKind kind;
  glm::dvec3 position_mm;
  ValueRange expected_hu;
  const char* name;
};

constexpr PhantomKind kHead = PhantomKind::head;
constexpr PhantomKind kAbdomen = PhantomKind::abdomen;
constexpr PhantomKind kKnees = PhantomKind::knees;

constexpr ValueRange kAir{-1024.0, -800.0};
constexpr ValueRange kFluid{-25.0, 40.0};
constexpr ValueRange kSoft{10.0, 80.0};
constexpr ValueRange kContrast{280.0, 420.0};
constexpr ValueRange kBone{270.0, 1400.0};

const std::vector<Landmark>& landmarks() {
  static const std::vector<Landmark> all{
      {kHead, {30, 20, 60}, kSoft, "brain"},
      {kHead, {0, -2, -135}, kAir, "trachea"},
      {kHead, {27, -55, -20}, kAir, "left maxillary sinus"},
      {kHead, {-27, -55, -20}, kAir, "right maxillary sinus"},
      {kHead, {4.4, -88.5, -50}, {1700.0, 2600.0}, "incisor"},
      {kHead, {32, -73, 12}, kFluid, "left eye"},
      {kHead, {26, 2, -130}, kContrast, "left carotid artery"},
      {kHead, {0, 15, -104}, kBone, "cervical vertebra"},
      {kHead, {0, 10, 114}, {250.0, 1300.0}, "skull"},
      {kHead, {77, 10, -28}, {1500.0, 3071.0}, "left earring"},
      {kHead, {-77, 10, -28}, {-1024.0, 200.0}, "no right earring"},
      {kAbdomen, {-90, -20, 90}, {85.0, 140.0}, "liver on the right"},
      {kAbdomen, {86, 34, 124}, {90.0, 150.0}, "spleen on the left"},
      {kAbdomen, {4, 14, 80}, kContrast, "aorta"},
      {kAbdomen, {-90, 20, 185}, {-900.0, -750.0}, "right lung"},
      {kAbdomen, {90, -4, -134}, kBone, "left femoral head"},
      {kAbdomen, {0, 31, 13}, kBone, "third lumbar vertebra"},
      {kAbdomen, {0, -34, -128}, kFluid, "bladder"},
      {kAbdomen, {0, -54, 14}, {-1000.0, -700.0}, "gas in the colon"},
      {kAbdomen, {60, -10, 112}, {-20.0, 80.0}, "stomach on the left"},
      {kKnees, {76, -7, 120}, {-80.0, -10.0}, "marrow of the left femur"},
      {kKnees, {88, -7, 120}, {900.0, 1400.0}, "compact bone of the left femur"},
      {kKnees, {71, -46, 38}, kBone, "left kneecap, in front"},
      {kKnees, {107, 23, -24}, kBone, "left fibula, outside"},
      {kKnees, {-107, 23, -24}, kBone, "right fibula, outside"},
      {kKnees, {33, 23, -50}, {-150.0, 120.0}, "no bone inside"},
      {kKnees, {85, 6, -34}, kFluid, "cyst in the left tibia"},
      {kKnees, {-85, 6, -34}, kBone, "no cyst in the right tibia"},
      {kKnees, {-70, 36, 20}, kContrast, "right popliteal artery"},
  };
  return all;
}

TEST(Phantoms, HaveEachTissueAtItsPlace) {
  for (const PhantomKind kind : {kHead, kAbdomen, kKnees}) {
    const Volume volume = make_phantom({.kind = kind, .size_voxels = 128}, {}, {});
    const glm::dmat4 to_index = patient_to_index(volume.geometry);
    for (const Landmark& landmark : landmarks()) {
      if (landmark.kind != kind) continue;
      const double value =
          sample(volume, glm::dvec3(to_index * glm::dvec4(landmark.position_mm, 1.0)));
      EXPECT_GE(value, landmark.expected_hu.minimum) << landmark.name;
      EXPECT_LE(value, landmark.expected_hu.maximum) << landmark.name;
    }
  }
}

/// Scanner noise may neither raise dots of skin in the air nor holes in solid bone: no voxel of the
/// air round the body comes near the iso-value of skin.
TEST(Phantoms, AirIsCleanAroundTheBody) {
  const Volume volume = make_phantom({.kind = kHead, .size_voxels = 64}, {}, {});
  double sum = 0.0;
  double sum_of_squares = 0.0;
  int count = 0;
  for (int k = 40; k < 64; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i, ++count) {
        const double value = value_at(volume, {i, j, k});
        EXPECT_LT(value, -900.0);
        sum += value;
        sum_of_squares += value * value;
      }
    }
  }
  const double mean = sum / count;
  EXPECT_NEAR(mean, -1000.0, 3.0);
  EXPECT_NEAR(std::sqrt(sum_of_squares / count - mean * mean), 10.0, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Phantom, EveryPhantom,
                         testing::Values(PhantomKind::head, PhantomKind::abdomen,
                                         PhantomKind::knees));

}  // namespace
}  // namespace cutaway
