// Scene files as anyone may hand them to `cutaway render`.
#include "app/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace cutaway {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class SceneFiles : public ::testing::Test {
 protected:
  SceneFiles() { fs::create_directories(folder_); }
  ~SceneFiles() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) const {
    fs::path file = folder_ / "scene.json";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  static std::string style(const std::string& scene, const std::string& more = "") {
    return R"({"name": "x", "title": "X", "description": "", "scene": )" + scene + more + "}";
  }

  static Error::Detail refusal(const fs::path& file) {
    try {
      read_scene_file(file);
    } catch (const Error& error) {
      return error.detail();
    }
    ADD_FAILURE() << file << " was taken";
    return {};
  }

  fs::path folder_ = fs::temp_directory_path() / ("cutaway-scene-" + std::to_string(getpid()));
};

TEST_F(SceneFiles, AreTakenAsSceneOrAsStyle) {
  EXPECT_EQ(read_scene_file(write(R"({"volume": "phantom:head"})"))["volume"], "phantom:head");
  EXPECT_EQ(read_scene_file(write(style(R"({"lens": {"radius_mm": 20}})")))["lens"]["radius_mm"],
            20);
}

TEST_F(SceneFiles, AStyleOfAnotherVersionOrWithUnknownFieldsIsRefused) {
  for (const char* version : {"0", "2"}) {
    const fs::path file = write(style("{}", std::string(R"(, "version": )") + version));
    EXPECT_EQ(refusal(file).code, ErrorCode::out_of_range) << version;
    EXPECT_EQ(refusal(file).field, file.string() + "#/version");
  }
  EXPECT_EQ(refusal(write(style("{}", R"(, "foo": 1)"))).code, ErrorCode::unknown_field);
  EXPECT_EQ(refusal(write(R"({"name": "x", "scene": {}})")).code, ErrorCode::missing_field);
}

TEST_F(SceneFiles, NestedTooDeeplyAreRefusedHoweverDeep) {
  for (const std::size_t depth : {33, 1000, 500'000}) {
    const fs::path file = write(std::string(depth, '['));
    EXPECT_EQ(refusal(file).code, ErrorCode::malformed_json) << depth;
    EXPECT_EQ(refusal(file).field, file.string());
  }
}

TEST_F(SceneFiles, ThatAreNoJsonSayWhere) {
  for (const char* text : {"", "nonsense", "{\"volume\": ", "\xff\xfe"}) {
    const Error::Detail detail = refusal(write(text));
    EXPECT_EQ(detail.code, ErrorCode::malformed_json) << text;
    EXPECT_THAT(detail.field, EndsWith("scene.json"));
    EXPECT_THAT(detail.message, HasSubstr("byte"));
  }
}

TEST_F(SceneFiles, WithAWrongFieldNameFileAndField) {
  const fs::path scene = write(R"({"lens": {"radius_mm": "large"}})");
  EXPECT_EQ(refusal(scene).code, ErrorCode::wrong_type);
  EXPECT_EQ(refusal(scene).field, scene.string() + "#/lens/radius_mm");
  const fs::path file = write(style(R"({"lens": {"radius_mm": "large"}})"));
  EXPECT_EQ(refusal(file).field, file.string() + "#/scene/lens/radius_mm");
  EXPECT_EQ(refusal(write(R"({"lens": {"radius_mm": 1e999}})")).code, ErrorCode::not_finite);
}

TEST_F(SceneFiles, OfEndlessLengthAreRefused) {
  EXPECT_EQ(refusal(write(std::string(2'000'000, ' '))).code, ErrorCode::too_large);
  EXPECT_EQ(refusal("/dev/zero").code, ErrorCode::too_large);
}

TEST_F(SceneFiles, FoldersAndPathsToNowhereAreRefused) {
  for (const fs::path& path : {folder_, folder_ / "none", fs::path()}) {
    EXPECT_EQ(refusal(path).code, ErrorCode::invalid_scene) << path;
    EXPECT_EQ(refusal(path).field, path.string());
  }
}

}  // namespace
}  // namespace cutaway
