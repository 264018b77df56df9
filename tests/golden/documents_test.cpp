// An old document draws its old picture.
#include "golden/documents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "scene/resolve.h"
#include "support/gpu_harness.h"
#include "support/stored_picture.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

/// Two rays a pixel each way and half a voxel a step, as `cutaway render` draws, which has recorded
/// them.
RenderSettings settings_of_render(Viewport viewport) {
  return {.picture_size_px = {viewport.width_px, viewport.height_px},
          .supersampling = 2,
          .step_voxels = 0.5};
}

std::shared_ptr<const LoadedVolume> phantom(const std::string& id) {
  static std::map<std::string, std::shared_ptr<const LoadedVolume>> loaded;
  auto& volume = loaded[id];
  if (!volume) volume = load(make_phantom(parse_phantom_id(id).value(), {}, {}));
  return volume;
}

BytePicture drawn(const Json& document) {
  const auto volume = phantom(document.at("volume").get<std::string>());
  const Scene scene = scene_for(document, volume, document_viewport(document));
  return GpuHarness::instance().render(scene, volume, settings_of_render(scene.viewport));
}

bool is_within(const PictureDifference& difference, const MostDifference& allowed) {
  return difference.mean <= allowed.mean && difference.share_above_2 <= allowed.share_above_2;
}

const GoldenDocument& document_named(const std::vector<GoldenDocument>& documents,
                                     const std::string& name) {
  const auto found = std::ranges::find(documents, name, &GoldenDocument::name);
  if (found == documents.end()) throw std::runtime_error("there is no document " + name);
  return *found;
}

class OldDocument : public testing::TestWithParam<GoldenDocument> {};

TEST_P(OldDocument, DrawsItsOldPicture) {
  const GoldenDocument& document = GetParam();
  const BytePicture actual = drawn(document.scene);
  const BytePicture expected = read_png(document.picture);
  ASSERT_EQ(actual.size_px, expected.size_px);
  const PictureDifference difference = compare(actual, expected);
  std::printf("%s: mean %.4f/255, %.3f %% of pixels above 2/255\n", document.name.c_str(),
              difference.mean, 100.0 * difference.share_above_2);
  const bool is_same = is_within(difference, document.allowed);
  EXPECT_TRUE(is_same) << "see " << (is_same ? "" : save_evidence(document.name, actual, expected));
}

std::string test_name(const testing::TestParamInfo<GoldenDocument>& info) {
  std::string name = info.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, OldDocument, testing::ValuesIn(golden_documents()), test_name);

TEST(OldDocuments, AreThereForEveryStyleOfTheirTime) {
  std::size_t of_styles = 0;
  for (const GoldenDocument& document : golden_documents())
    if (document.name.starts_with("style-") && document.name.ends_with("-head")) ++of_styles;
  EXPECT_EQ(of_styles, 24);
}

/// What is chosen for a volume may be chosen otherwise one day.
TEST(OldDocuments, LeaveNothingToBeChosenForTheVolume) {
  for (const GoldenDocument& document : golden_documents()) {
    const Viewport viewport = document_viewport(document.scene);
    const Json here =
        scene_document(scene_for(document.scene, phantom("phantom:head@32"), viewport));
    const Json there =
        scene_document(scene_for(document.scene, phantom("phantom:knees@32"), viewport));
    EXPECT_EQ(here, there) << document.name << " " << Json::diff(here, there);
  }
}

/// A comparison that no change of a look can fail would prove nothing.
TEST(OldDocuments, AreToldApartFromOtherLooks) {
  const auto documents = golden_documents();
  const GoldenDocument& flagship = document_named(documents, "style-flagship-head");
  const BytePicture expected = read_png(flagship.picture);
  for (const Json& change :
       {Json{{"lens", {{"mode", "magic"}}}}, Json{{"context", {{"filters", Json::array()}}}},
        Json{{"light", {{"direction", {0.5, 0.7, 0.5}}}}},
        Json{{"context", {{"surface", {{"opacity", 0.2}}}}}}}) {
    const BytePicture other = drawn(patch_scene_document(flagship.scene, change));
    EXPECT_FALSE(is_within(compare(other, expected), flagship.allowed)) << change;
  }
}

TEST(OldOwnStyles, PutOnMakeTheSceneThatTheyMade) {
  const auto documents = golden_documents();
  const Json& before = document_named(documents, "style-flagship-head").scene;
  EXPECT_FALSE(old_own_styles().empty());
  for (const OldOwnStyle& style : old_own_styles())
    EXPECT_EQ(patch_scene_document(before, style.scene),
              document_named(documents, style.name).scene)
        << style.name;
}

}  // namespace
}  // namespace cutaway::test
