#include "gl/shader_library.h"

#include <gtest/gtest.h>

#include <array>

#include "core/error.h"
#include "core/start_up_error.h"
#include "gl/context.h"
#include "gl/program.h"

namespace cutaway::gl {
namespace {

constexpr std::array kFiles{
    EmbeddedFile{"pass.vert", "#version 450 core\nvoid main() { gl_Position = vec4(0.0); }\n"},
    EmbeddedFile{"common.glsl", "float one() {\n  return 1.0;\n}\n"},
    EmbeddedFile{"broken.glsl", "float two() {\n  return two_is_not_defined;\n}\n"},
    EmbeddedFile{"good.frag",
                 "#version 450 core\n#include \"common.glsl\"\n#include \"common.glsl\"\n"
                 "out vec4 colour;\nvoid main() { colour = vec4(one() * SCALE); }\n"},
    EmbeddedFile{"chosen.frag",
                 "#version 450 core\n#include PART\nout vec4 colour;\nvoid main() { colour = "
                 "vec4(one()); }\n"},
    EmbeddedFile{"bad.frag",
                 "#version 450 core\n#include \"common.glsl\"\n#include \"broken.glsl\"\n"
                 "out vec4 colour;\nvoid main() { colour = vec4(two()); }\n"},
    EmbeddedFile{"own_error.frag",
                 "#version 450 core\n#include \"common.glsl\"\nout vec4 colour;\n\nvoid main() { "
                 "nonsense; }\n"},
    EmbeddedFile{"tinted.frag",
                 "#version 450 core\nuniform float tint;\nuniform float unread;\nout vec4 colour;\n"
                 "void main() { colour = vec4(tint); }\n"},
    EmbeddedFile{"lost.frag", "#version 450 core\n#include \"nowhere.glsl\"\n"},
};

std::string error_of(const char* fragment) {
  const auto context = Context::create({});
  try {
    const Program program(ShaderLibrary(kFiles), "pass.vert", fragment);
  } catch (const StartUpError& error) {
    return error.what();
  }
  return "";
}

TEST(ShaderLibrary, PutsEachIncludeInOnceAndDefinitionsFirst) {
  const auto context = Context::create({});
  EXPECT_NO_THROW(Program(ShaderLibrary(kFiles), "pass.vert", "good.frag", {{"SCALE", "0.5"}}));
}

TEST(ShaderLibrary, IncludesTheFileThatADefinitionNames) {
  const auto context = Context::create({});
  EXPECT_NO_THROW(
      Program(ShaderLibrary(kFiles), "pass.vert", "chosen.frag", {{"PART", "\"common.glsl\""}}));
}

TEST(ShaderLibrary, ErrorsNameTheIncludedFileAndItsLine) {
  EXPECT_NE(error_of("bad.frag").find("broken.glsl:2"), std::string::npos) << error_of("bad.frag");
}

TEST(ShaderLibrary, ErrorsAfterAnIncludeNameTheIncludersLine) {
  EXPECT_NE(error_of("own_error.frag").find("own_error.frag:5"), std::string::npos)
      << error_of("own_error.frag");
}

TEST(ShaderLibrary, UnknownIncludeSaysWhoWantedIt) {
  try {
    ShaderLibrary(kFiles).expand("lost.frag");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().field, "lost.frag:2");
    EXPECT_EQ(error.detail().received, "nowhere.glsl");
  }
}

TEST(Program, InADebugContextAMisspeltUniformIsAnError) {
  const auto context = Context::create({.debug_output = true});
  const Program program(ShaderLibrary(kFiles), "pass.vert", "tinted.frag");
  EXPECT_NO_THROW(program.set("tint", 0.5F));
  EXPECT_NO_THROW(program.set("unread", 0.5F)) << "the linker dropped it";
  EXPECT_THROW(program.set("tnit", 0.5F), StartUpError);
}

TEST(NameFilesInLog, KnowsBothDriversForms) {
  const std::vector<std::string> names{"a.frag", "b.glsl"};
  EXPECT_EQ(name_files_in_log("1:12(3): error: x\n", names), "b.glsl:12(3): error: x\n");
  EXPECT_EQ(name_files_in_log("0(7) : error C1000: y\n", names), "a.frag:7 : error C1000: y\n");
}

}  // namespace
}  // namespace cutaway::gl
