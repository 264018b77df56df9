// What is uploaded covers what GL reads, or is refused.
#include "gl/texture.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "gl/context.h"

namespace cutaway::gl {
namespace {

constexpr glm::ivec3 kSize(3, 2, 5);
constexpr std::size_t kTexels = 30;

class Textures : public ::testing::Test {
 protected:
  /// Of the first `count` of 1, 2, 3 ...
  static std::vector<std::uint16_t> numbered(std::size_t count) {
    std::vector<std::uint16_t> values(count);
    std::iota(values.begin(), values.end(), std::uint16_t{1});
    return values;
  }

  void clear() {
    const std::vector<std::uint16_t> zeros(kTexels);
    texture_.upload_slices(0, kSize.z, std::as_bytes(std::span(zeros)));
  }

  std::vector<std::uint16_t> texels() const {
    std::vector<std::uint16_t> values(kTexels, 0xffff);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture_.name(), 0, GL_RED, GL_UNSIGNED_SHORT,
                      static_cast<GLsizei>(values.size() * sizeof(values[0])), values.data());
    return values;
  }

  std::unique_ptr<Context> context_ = Context::create({.debug_output = true});
  Texture3D texture_{GL_R16, kSize, Filtering::nearest};
};

TEST_F(Textures, TakeTheirSlicesInAnyOrder) {
  const std::vector<std::uint16_t> whole = numbered(kTexels);
  texture_.upload_slices(3, 2, std::as_bytes(std::span(whole)));
  texture_.upload_slices(0, 3, std::as_bytes(std::span(whole)));
  EXPECT_EQ(texels(), whole);
}

TEST_F(Textures, TakeAFloatATexel) {
  std::vector<float> whole(kTexels);
  std::iota(whole.begin(), whole.end(), 0.5F);
  Texture3D floats(GL_R32F, kSize, Filtering::nearest);
  floats.upload_slices(0, kSize.z, std::as_bytes(std::span(whole)));
  std::vector<float> read(kTexels);
  glGetTextureImage(floats.name(), 0, GL_RED, GL_FLOAT,
                    static_cast<GLsizei>(read.size() * sizeof(float)), read.data());
  EXPECT_EQ(read, whole);
}

TEST_F(Textures, TakeNoBytesOfAnotherSize) {
  clear();
  const std::vector<std::uint16_t> more = numbered(kTexels + 1);
  for (const std::size_t count : {std::size_t{0}, kTexels - 1, kTexels + 1}) {
    const auto bytes = std::as_bytes(std::span(more).first(count));
    EXPECT_THROW(texture_.upload_slices(0, 1, bytes), std::out_of_range) << count;
  }
  EXPECT_EQ(texels(), std::vector<std::uint16_t>(kTexels));
}

TEST_F(Textures, HaveNoSlicesBesideThem) {
  const std::vector<std::uint16_t> whole = numbered(kTexels);
  const auto bytes = std::as_bytes(std::span(whole));
  clear();
  EXPECT_THROW(texture_.upload_slices(-1, 2, bytes), std::out_of_range);
  EXPECT_THROW(texture_.upload_slices(4, 2, bytes), std::out_of_range);
  EXPECT_THROW(texture_.upload_slices(6, 0, bytes), std::out_of_range);
  EXPECT_THROW(texture_.upload_slices(0, -1, bytes), std::out_of_range);
  EXPECT_EQ(texels(), std::vector<std::uint16_t>(kTexels));
}

}  // namespace
}  // namespace cutaway::gl
