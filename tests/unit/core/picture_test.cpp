// Pixels as a value: what does not fit is refused in every build, and nothing beside it is touched.
#include "core/picture.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cutaway {
namespace {

/// Each byte another one.
PixelPlane numbered(glm::ivec2 size_px, int bytes_per_pixel) {
  std::vector<std::uint8_t> bytes(packed_bytes(size_px, bytes_per_pixel));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i % 251 + 1);
  return {size_px, bytes_per_pixel, bytes};
}

Picture numbered(PixelLayout layout, glm::ivec2 size_px) {
  std::vector<PixelPlane> planes;
  for (const PlaneShape& shape : plane_shapes(layout, size_px))
    planes.push_back(numbered(shape.size_px, shape.bytes_per_pixel));
  return {layout, size_px, std::move(planes)};
}

TEST(PixelPlane, CopiesAPartAndLeavesTheRest) {
  const PixelPlane from = numbered({7, 5}, 3);
  PixelPlane to({9, 6}, 3);
  to.copy(from, {{2, 1}, {6, 4}}, {5, 3});
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 9; ++x) {
      const bool is_taken = x >= 5 && y >= 3;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(x) * 3 + i;
        const int expected = is_taken ? from.row(y - 2)[at - 9] : 0;
        EXPECT_EQ(to.row(y)[at], expected) << x << ", " << y;
      }
    }
  }
}

struct BadCopy {
  const char* name;
  PixelRect part;
  glm::ivec2 at;
};

class BadCopies : public ::testing::TestWithParam<BadCopy> {};

TEST_P(BadCopies, AreRefusedAndChangeNothing) {
  const PixelPlane from = numbered({8, 6}, 1);
  PixelPlane to({10, 4}, 1);
  EXPECT_THROW(to.copy(from, GetParam().part, GetParam().at), std::out_of_range);
  EXPECT_EQ(to, PixelPlane({10, 4}, 1));
}

std::string bad_copy_name(const ::testing::TestParamInfo<BadCopy>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    PixelPlane, BadCopies,
    ::testing::Values(BadCopy{"begins_before_the_source", {{-1, 0}, {2, 2}}, {0, 0}},
                      BadCopy{"ends_behind_the_source", {{4, 0}, {9, 2}}, {0, 0}},
                      BadCopy{"is_lower_than_the_source", {{0, 4}, {2, 7}}, {0, 0}},
                      BadCopy{"ends_before_it_begins", {{3, 3}, {2, 4}}, {0, 0}},
                      BadCopy{"is_put_before_the_target", {{0, 0}, {2, 2}}, {0, -1}},
                      BadCopy{"is_put_too_far_right", {{0, 0}, {3, 2}}, {8, 0}},
                      BadCopy{"is_put_too_far_down", {{0, 0}, {2, 2}}, {0, 3}}),
    bad_copy_name);

TEST(PixelPlane, TakesNoPixelsOfAnotherSize) {
  PixelPlane to({4, 4}, 4);
  EXPECT_THROW(to.copy(numbered({4, 4}, 1), {{0, 0}, {1, 1}}, {0, 0}), std::out_of_range);
}

TEST(PixelPlane, TakesExactlyItsBytes) {
  const std::vector<std::uint8_t> bytes(12);
  EXPECT_NO_THROW(PixelPlane({4, 3}, 1, bytes));
  EXPECT_THROW(PixelPlane({4, 3}, 4, bytes), std::out_of_range);
  EXPECT_THROW(PixelPlane({4, 2}, 1, bytes), std::out_of_range);
  EXPECT_THROW(PixelPlane({-4, -3}, 1, bytes), std::out_of_range);
}

TEST(PixelPlane, HasNoRowBesideIt) {
  PixelPlane plane({4, 3}, 1);
  EXPECT_EQ(plane.row(2).size(), 4U);
  EXPECT_THROW(plane.row(3), std::out_of_range);
  EXPECT_THROW(plane.row(-1), std::out_of_range);
}

// Else its size would promise bytes that another plane has now.
TEST(PixelPlane, HasNoPixelsOnceItIsMovedFrom) {
  PixelPlane made = numbered({4, 3}, 1);
  const PixelPlane taken = std::move(made);
  EXPECT_EQ(taken, numbered({4, 3}, 1));
  EXPECT_EQ(made.size_px(), glm::ivec2(0));  // NOLINT(bugprone-use-after-move): it is the question
  EXPECT_THROW(made.row(0), std::out_of_range);
  PixelPlane target({4, 3}, 1);
  EXPECT_THROW(target.copy(made, {{0, 0}, {1, 1}}, {0, 0}), std::out_of_range);
  made = PixelPlane({2, 2}, 1);
  made = PixelPlane({1, 1}, 4);
  EXPECT_EQ(made, PixelPlane({1, 1}, 4));
}

TEST(Picture, HasNoPixelsOnceItIsMovedFrom) {
  Picture made = numbered(PixelLayout::yuv420, {8, 8});
  const Picture taken = std::move(made);
  EXPECT_EQ(taken, numbered(PixelLayout::yuv420, {8, 8}));
  EXPECT_EQ(made.size_px(), glm::ivec2(0));  // NOLINT(bugprone-use-after-move): it is the question
  Picture target(PixelLayout::yuv420, {8, 8});
  EXPECT_THROW(target.copy(made, {{0, 0}, {2, 2}}, {0, 0}), std::out_of_range);
}

TEST(Picture, TakesThePlanesOfItsLayoutAlone) {
  const glm::ivec2 size_px(5, 3);
  EXPECT_THROW(Picture(PixelLayout::rgba, size_px, {numbered(size_px, 1)}), std::out_of_range);
  EXPECT_THROW(Picture(PixelLayout::yuv444, size_px, {numbered(size_px, 1)}), std::out_of_range);
  const PixelPlane luma = numbered({6, 4}, 1);
  const PixelPlane chroma = numbered({3, 2}, 1);
  EXPECT_NO_THROW(Picture(PixelLayout::yuv420, size_px, {luma, chroma, chroma}));
  EXPECT_THROW(Picture(PixelLayout::yuv444, size_px, {luma, chroma, chroma}), std::out_of_range);
}

class Layouts : public ::testing::TestWithParam<PixelLayout> {};

TEST_P(Layouts, ArePutTogetherFromParts) {
  for (const glm::ivec2 size_px : {glm::ivec2(11, 9), {12, 8}, {1, 1}, {2, 7}}) {
    const Picture whole = numbered(GetParam(), size_px);
    Picture put(GetParam(), size_px);
    for (int y = 0; y < size_px.y; y += 4) {
      for (int x = 0; x < size_px.x; x += 6) {
        const PixelRect part{{x, y}, glm::min(glm::ivec2(x + 6, y + 4), size_px)};
        put.copy(whole, part, part.begin);
      }
    }
    EXPECT_EQ(put, whole) << size_px.x << " x " << size_px.y;
  }
}

TEST_P(Layouts, RefuseAPartBesideThem) {
  const Picture from = numbered(GetParam(), {8, 8});
  Picture to(GetParam(), {8, 8});
  EXPECT_THROW(to.copy(from, {{0, 0}, {10, 2}}, {0, 0}), std::out_of_range);
  EXPECT_THROW(to.copy(from, {{0, 0}, {2, 2}}, {8, 0}), std::out_of_range);
  EXPECT_EQ(to, Picture(GetParam(), {8, 8}));
}

INSTANTIATE_TEST_SUITE_P(All, Layouts,
                         ::testing::Values(PixelLayout::yuv420, PixelLayout::yuv444,
                                           PixelLayout::rgba));

// Else a strip's first row of chroma would be its neighbour's.
TEST(Picture, CutsNoBlockOfChroma) {
  const Picture from = numbered(PixelLayout::yuv420, {8, 8});
  Picture to(PixelLayout::yuv420, {8, 8});
  EXPECT_THROW(to.copy(from, {{0, 1}, {8, 4}}, {0, 0}), std::out_of_range);
  EXPECT_THROW(to.copy(from, {{0, 0}, {8, 3}}, {0, 0}), std::out_of_range);
  EXPECT_THROW(to.copy(from, {{0, 0}, {8, 4}}, {0, 3}), std::out_of_range);
  EXPECT_NO_THROW(to.copy(from, {{0, 0}, {8, 4}}, {0, 4}));
}

TEST(Picture, TakesNoneOfAnotherLayout) {
  Picture to(PixelLayout::rgba, {8, 8});
  EXPECT_THROW(to.copy(Picture(PixelLayout::yuv444, {8, 8}), {{0, 0}, {2, 2}}, {0, 0}),
               std::out_of_range);
}

}  // namespace
}  // namespace cutaway
