#include "scene/first_look.h"

#include <gtest/gtest.h>

#include "scene/resolve.h"
#include "scene/scene_json.h"
#include "scene/styles.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

constexpr Viewport kViewport{640, 480};

VolumeFacts facts_with(const std::string& style) {
  VolumeFacts facts = ball_facts();
  facts.first_style = style;
  return facts;
}

Json shown(const Json& document, const VolumeFacts& facts) {
  return scene_document(resolve_scene(with_first_look(document, facts), facts, kViewport));
}

TEST(FirstLook, IsTheStyleThatSuitsTheVolume) {
  const VolumeFacts facts = facts_with("brain");
  const Json document = {{"volume", "balls"}, {"camera", {{"projection", "orthographic"}}}};
  Json with_style = document;
  with_style.merge_patch(style("brain").scene);
  EXPECT_EQ(with_first_look(document, facts), with_style);
}

TEST(FirstLook, LeavesADocumentThatSaysAWordOfALook) {
  const VolumeFacts facts = facts_with("brain");
  for (const Json& document :
       {Json{{"lens", {{"cap", "open"}}}}, Json{{"light", {{"frame", "patient"}}}},
        Json{{"focus", {{"filters", Json::array()}}}}})
    EXPECT_EQ(with_first_look(document, facts), document);
}

TEST(FirstLook, OfFactsThatNameNoneIsTheSchemas) {
  EXPECT_EQ(with_first_look(Json::object(), facts_with("")), Json::object());
}

TEST(FirstLook, IsKnownAgainUntilSomebodyTouchesIt) {
  const VolumeFacts facts = facts_with("night");
  Json document = shown({{"lens", {{"radius_mm", 12.0}}}}, facts);
  EXPECT_TRUE(has_first_look(document, facts, kViewport));
  document["focus"]["shading"]["gamma"] = 2.5;
  EXPECT_FALSE(has_first_look(document, facts, kViewport));
}

}  // namespace
}  // namespace cutaway
