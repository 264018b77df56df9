#include "volume/voxel_packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace cutaway {
namespace {

template <typename T>
std::vector<double> physical(const std::vector<T>& values, double slope = 1.0,
                             double intercept = 0.0) {
  const PackedVoxels packed = pack_voxels(std::span<const T>(values), slope, intercept);
  std::vector<double> result;
  std::visit(
      [&](const auto& stored) {
        for (const auto v : stored) {
          result.push_back(double(v) * packed.value_scale + packed.value_offset);
        }
      },
      packed.voxels);
  return result;
}

template <typename T>
bool is_uint16(const std::vector<T>& values) {
  return std::holds_alternative<std::vector<std::uint16_t>>(
      pack_voxels(std::span<const T>(values)).voxels);
}

template <typename T>
class PackEveryInteger : public testing::Test {};
using Integers = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                std::int32_t, std::uint32_t>;
TYPED_TEST_SUITE(PackEveryInteger, Integers);

TYPED_TEST(PackEveryInteger, KeepsEachValueIncludingTheExtremes) {
  using Limits = std::numeric_limits<TypeParam>;
  const std::vector<TypeParam> values{Limits::min(), TypeParam(1), TypeParam(100), Limits::max()};
  const std::vector<double> result = physical(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(result[i], double(float(values[i])));
  }
  EXPECT_EQ(is_uint16(values), sizeof(TypeParam) <= 2);
}

TEST(PackVoxels, WideIntegersOfANarrowRangeAre16Bit) {
  const std::vector<std::int32_t> values{-1'000'000, -1'000'000 + 65535};
  EXPECT_TRUE(is_uint16(values));
  EXPECT_EQ(physical(values), (std::vector<double>{-1'000'000.0, -934'465.0}));
  EXPECT_FALSE(is_uint16(std::vector<std::int32_t>{-1'000'000, -1'000'000 + 65536}));
}

TEST(PackVoxels, AppliesTheRescaleOnceAndOrdersTheRange) {
  const std::vector<std::int16_t> values{-10, 0, 20};
  const PackedVoxels packed = pack_voxels(std::span<const std::int16_t>(values), -2.0, 5.0);
  EXPECT_EQ(physical(values, -2.0, 5.0), (std::vector<double>{25.0, 5.0, -35.0}));
  EXPECT_EQ(packed.value_range, (ValueRange{-35.0, 25.0}));
  EXPECT_EQ(physical(std::vector<float>{1.0f, 2.0f}, 10.0, 1.0), (std::vector<double>{11.0, 21.0}));
}

/// Stored values are compared, and gradients are taken of them, without a look at the scale.
TEST(PackVoxels, ANegativeSlopeGivesTheSameAsTheValuesThatItMeans) {
  const std::vector<std::int16_t> values{-10, 0, 20, 32767};
  std::vector<std::int16_t> negated;
  for (const auto v : values) negated.push_back(std::int16_t(-v));
  const PackedVoxels plain = pack_voxels(std::span<const std::int16_t>(values), 1.0, 7.0);
  const PackedVoxels turned = pack_voxels(std::span<const std::int16_t>(negated), -1.0, 7.0);
  EXPECT_EQ(turned.value_scale, 1.0);
  EXPECT_EQ(turned.value_offset, -3.0);
  EXPECT_EQ(turned.voxels, plain.voxels);
  EXPECT_EQ(turned.value_range, plain.value_range);
  EXPECT_EQ(physical(negated, -1.0, 7.0), (std::vector<double>{-3.0, 7.0, 27.0, 32774.0}));
}

TEST(PackVoxels, EachSlopeLeavesAScaleAboveZero) {
  const std::vector<std::uint8_t> bytes{0, 100, 255};
  const std::vector<float> floats{-1.0f, 0.5f};
  for (const double slope : {-3.0, -0.001, 0.001, 3.0}) {
    EXPECT_GT(pack_voxels(std::span<const std::uint8_t>(bytes), slope).value_scale, 0.0);
    EXPECT_GT(pack_voxels(std::span<const float>(floats), slope).value_scale, 0.0);
  }
}

TEST(PackVoxels, FloatsFarFromOneAreStoredNearItWithoutLoss) {
  for (const float factor : {1e-30f, 1e-6f, 1e20f, 1e38f}) {
    const std::vector<float> values{-2.0f * factor, 0.3f * factor, 3.0f * factor};
    const PackedVoxels packed = pack_voxels(std::span<const float>(values));
    EXPECT_EQ(physical(values), (std::vector<double>(values.begin(), values.end())));
    EXPECT_EQ(packed.value_range, (ValueRange{values.front(), values.back()}));
    for (const float stored : std::get<std::vector<float>>(packed.voxels)) {
      EXPECT_LE(std::abs(stored), 2.0f);
    }
  }
}

TEST(PackVoxels, ARescaleBeyondFloatsIsNotFinite) {
  const std::vector<std::int16_t> values{0, 1};
  const PackedVoxels packed = pack_voxels(std::span<const std::int16_t>(values), 1e300);
  EXPECT_EQ(packed.nothing_voxels, 1u);
  EXPECT_EQ(packed.value_range, (ValueRange{0.0, 0.0}));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Else a body of the smallest value and what is not there would be one.
TEST(PackVoxels, WhatIsNotFiniteLiesBelowAllValues) {
  const std::vector<float> values{kNan, 3.0f, -kInfinity, -2.0f, kInfinity};
  const PackedVoxels packed = pack_voxels(std::span<const float>(values));
  EXPECT_EQ(packed.nothing_voxels, 3u);
  EXPECT_EQ(packed.nothing_value, -3.0);
  EXPECT_EQ(packed.value_range, (ValueRange{-2.0, 3.0}));
  EXPECT_EQ(physical(values), (std::vector<double>{-3.0, 3.0, -3.0, -2.0, -3.0}));
}

TEST(PackVoxels, NothingIsAValueOfItsOwnWhateverTheOthersAre) {
  for (const std::vector<float>& values :
       {std::vector{0.25f, kNan, 0.75f}, std::vector{0.7f, kNan, 0.7f}, std::vector{0.0f, kNan},
        std::vector{1e30f, kNan, 1.5e30f}, std::vector{-1e-30f, kNan, 1e-31f},
        std::vector{16777216.0f * 4, kNan}}) {
    const PackedVoxels packed = pack_voxels(std::span<const float>(values));
    ASSERT_TRUE(packed.nothing_value.has_value());
    EXPECT_LT(*packed.nothing_value, packed.value_range.minimum);
    EXPECT_LT(physical(values)[1], packed.value_range.minimum);
  }
}

TEST(PackVoxels, IntegersThatAreNotValidLieBelowAllValues) {
  const std::vector<std::int16_t> values{-32768, 5, 7};
  const ValidValues<std::int16_t> valid{.lowest = -32767};
  const std::span<const std::int16_t> span(values);
  const PackedVoxels packed = pack_voxels(span, 2.0, 1.0, valid);
  EXPECT_EQ(packed.value_range, (ValueRange{11.0, 15.0}));
  EXPECT_EQ(packed.nothing_value, 9.0);
  EXPECT_EQ(packed.voxels, Voxels(std::vector<std::uint16_t>{0, 1, 3}));
  const PackedVoxels falling = pack_voxels(span, -2.0, 1.0, valid);
  EXPECT_EQ(falling.value_range, (ValueRange{-13.0, -9.0}));
  EXPECT_EQ(falling.nothing_value, -15.0);
  EXPECT_EQ(falling.voxels, Voxels(std::vector<std::uint16_t>{0, 3, 1}));
}

/// 65536 values leave no place for one more in 16 bits.
TEST(PackVoxels, AFullRangeOfIntegersWithNothingIsStoredAsFloats) {
  const std::vector<std::int32_t> values{0, 65535, -9999};
  const PackedVoxels packed =
      pack_voxels(std::span<const std::int32_t>(values), 1.0, 0.0, {.lowest = 0});
  EXPECT_EQ(packed.voxels, Voxels(std::vector<float>{0.0f, 65535.0f, -1.0f}));
}

TEST(PackVoxels, ADoubleTooLargeForAFloatIsNotFinite) {
  const std::vector<double> values{1e300, 0.5};
  EXPECT_EQ(pack_voxels(std::span<const double>(values)).nothing_voxels, 1u);
  EXPECT_EQ(physical(values), (std::vector<double>{-0.5, 0.5}));
}

/// A caller may give back or overwrite what is behind, in pieces, whatever it becomes.
TEST(PackVoxels, NeverLooksBackAtWhatItHasConsumed) {
  for (const bool narrow : {true, false}) {
    std::vector<std::int32_t> values((std::size_t{1} << 23) + 5);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = std::int32_t(i % 1000) * (narrow ? 1 : 1000);
    std::size_t last = 0;
    int pieces = 0;
    const PackedVoxels packed =
        pack_voxels<std::int32_t>(values, 1.0, 0.0, {}, [&](std::size_t done) {
          std::fill(values.begin() + std::ptrdiff_t(last), values.begin() + std::ptrdiff_t(done),
                    -7);
          last = done;
          ++pieces;
        });
    EXPECT_EQ(last, values.size());
    EXPECT_EQ(pieces, 3);
    EXPECT_EQ(packed.value_range, (ValueRange{0.0, narrow ? 999.0 : 999000.0}));
    std::visit([&](const auto& v) { EXPECT_EQ(v[1999], narrow ? 999 : 999000); }, packed.voxels);
  }
}

TEST(PackVoxels, RefusesVoxelsWithoutAFiniteValue) {
  const std::vector<double> values(3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(pack_voxels(std::span<const double>(values)), Error);
  EXPECT_THROW(pack_voxels(std::span<const double>()), Error);
}

TEST(PackVoxels, RefusesAnUnusableRescale) {
  const std::vector<std::uint8_t> values{1, 2};
  const std::span<const std::uint8_t> span(values);
  EXPECT_THROW(pack_voxels(span, 0.0), Error);
  EXPECT_THROW(pack_voxels(span, std::numeric_limits<double>::quiet_NaN()), Error);
  EXPECT_THROW(pack_voxels(span, 1.0, std::numeric_limits<double>::infinity()), Error);
}

}  // namespace
}  // namespace cutaway
