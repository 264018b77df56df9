#include <gtest/gtest.h>

#include "gl/context.h"
#include "gl/pixel_readback.h"

namespace cutaway::gl {
namespace {

TEST(PixelReadback, BringsSeveralAttachmentsTightlyPacked) {
  const auto context = Context::create({.debug_output = true});
  const Texture2D red(GL_R8, {5, 3}, Filtering::nearest);
  const Texture2D colour(GL_RGBA8, {3, 2}, Filtering::nearest);
  const Framebuffer red_target({&red});
  const Framebuffer colour_target({&colour});
  const float grey[] = {0.2F, 0.0F, 0.0F, 0.0F};
  const float mixed[] = {1.0F, 0.4F, 0.0F, 0.6F};
  glClearNamedFramebufferfv(red_target.name(), GL_COLOR, 0, grey);
  glClearNamedFramebufferfv(colour_target.name(), GL_COLOR, 0, mixed);

  PixelReadback readback;
  for (int round = 0; round < 3; ++round) {  // the buffer is used again
    const PixelReadback::Source sources[] = {{&red_target, {5, 3}, 0, 1},
                                             {&colour_target, {3, 2}, 0, 4}};
    readback.start(sources);
    const auto planes = readback.finish();
    ASSERT_EQ(planes.size(), 2U);
    EXPECT_EQ(planes[0], PixelPlane({5, 3}, 1, std::vector<std::uint8_t>(15, 51)));
    ASSERT_EQ(planes[1].size_px(), glm::ivec2(3, 2));
    const auto first = planes[1].row(0).first(4);
    EXPECT_EQ(std::vector<std::uint8_t>(first.begin(), first.end()),
              (std::vector<std::uint8_t>{255, 102, 0, 153}));
  }
}

}  // namespace
}  // namespace cutaway::gl
