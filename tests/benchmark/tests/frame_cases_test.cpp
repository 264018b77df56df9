#include "benchmark/frame_cases.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "benchmark/options.h"
#include "render/filters/filter_registry.h"
#include "scene/lenses/lens_shape.h"
#include "scene/resolve.h"

namespace cutaway::benchmark {
namespace {

using testing::Contains;

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const FrameCase& each : frame_cases()) result.push_back(each.name);
  return result;
}

const FrameCase& named(const std::vector<FrameCase>& cases, const std::string& name) {
  return *std::ranges::find(cases, name, &FrameCase::name);
}

TEST(FrameCases, HaveNamesOfTheirOwnAndScenesThatTheSchemaTakes) {
  const auto all = names();
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  for (const FrameCase& each : frame_cases())
    EXPECT_NO_THROW(validate_scene_document(each.scene)) << each.name;
}

TEST(FrameCases, MeasureEachFilterOfTheRegistryAlone) {
  const auto cases = frame_cases();
  ASSERT_FALSE(image_filters().empty());
  for (const ImageFilter& filter : image_filters()) {
    const std::string name = std::string(filter.name) + " alone";
    ASSERT_THAT(names(), Contains(name));
    Json scene = named(cases, name).scene;
    EXPECT_EQ(scene["context"]["filters"], Json::array({{{"name", filter.name}}}));
    scene["context"]["filters"] = Json::array();
    EXPECT_EQ(scene, cases.front().scene) << "more than the filter differs from the control";
  }
}

TEST(FrameCases, MeasureEachLensInEachMode) {
  const auto cases = frame_cases();
  ASSERT_FALSE(lens_shapes().empty());
  for (const std::string mode : {"cutaway", "magic"}) {
    for (const LensShape& shape : lens_shapes()) {
      const std::string name = mode + ' ' + shape.name + " alone";
      ASSERT_THAT(names(), Contains(name));
      const FrameCase& each = named(cases, name);
      EXPECT_EQ(each.scene["lens"]["mode"], mode);
      EXPECT_EQ(each.scene["lens"]["shape"]["name"], shape.name);
      EXPECT_FALSE(each.has_no_lens());
    }
  }
}

TEST(FrameCases, MeasureTranslucentMaterialAlone) {
  const auto cases = frame_cases();
  const Json& scene = named(cases, "translucent alone").scene;
  EXPECT_GT(scene["context"]["surface"]["opacity"], 0.0);
  EXPECT_LT(scene["context"]["surface"]["opacity"], 1.0);
}

TEST(FrameCases, BeginWithTheControlAndHaveTheFlagship) {
  const auto cases = frame_cases();
  EXPECT_TRUE(cases.front().has_no_lens());
  EXPECT_EQ(named(cases, flagship_case().name).scene, flagship_case().scene);
}

TEST(FrameCases, AreChosenByAPartOfTheirName) {
  EXPECT_EQ(std::ranges::count_if(
                names(), [](const std::string& name) { return is_wanted(name, {"sobel al"}); }),
            1);
}

}  // namespace
}  // namespace cutaway::benchmark
