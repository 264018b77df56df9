#include "gl/context.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "core/start_up_error.h"
#include "gl/context_display.h"

namespace cutaway::gl {
namespace {

TEST(Context, OffersOpenGl45WithoutADisplay) {
  const auto context = Context::create({.debug_output = true});
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(major * 10 + minor, 45);
  EXPECT_FALSE(context->renderer().empty());
  EXPECT_GE(context->max_3d_texture_size(), 512);
  EXPECT_FALSE(context->is_lost());
}

TEST(Context, TriesHardwareBeforeSoftware) {
  const auto candidates = find_display_candidates();
  ASSERT_FALSE(candidates.empty());
  bool software_seen = false;
  for (const auto& candidate : candidates) {
    EXPECT_FALSE(software_seen && !candidate.software) << candidate.name << " comes after software";
    software_seen = software_seen || candidate.software;
  }
}

TEST(Context, RefusesSoftwareInWordsWhereAGpuIsRequired) {
  try {
    const auto context = Context::create({.require_gpu = true});
    EXPECT_FALSE(context->is_software());
  } catch (const StartUpError& error) {
    EXPECT_EQ(error.fault(), StartUpError::Fault::renderer_unavailable);
    EXPECT_NE(std::string(error.what()).find("software"), std::string::npos) << error.what();
  }
}

TEST(Context, CanBeMadeAgainAfterItWentAway) {
  Context::create({}).reset();
  EXPECT_FALSE(Context::create({})->renderer().empty());
}

}  // namespace
}  // namespace cutaway::gl
