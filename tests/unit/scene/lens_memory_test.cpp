#include "scene/lens_memory.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/resolve.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

constexpr const char* kOpenLens = R"({"lens": {"strength": 0.5}})";

class LensMemoryTest : public ::testing::Test {
 protected:
  Scene resolved(const char* document, Viewport viewport = {640, 480}) {
    return resolve_scene(Json::parse(document), facts, viewport, lenses);
  }

  VolumeFacts facts = ball_facts();
  LensMemory lenses;
};

TEST_F(LensMemoryTest, LooksOnceForTheSameQuestion) {
  const Scene first = resolved(kOpenLens);
  EXPECT_EQ(resolved(R"({"lens": {"cap": "open"}})").lens.centre_mm, first.lens.centre_mm);
  EXPECT_EQ(lenses.take_searches(), 1);
  EXPECT_EQ(lenses.take_searches(), 0);
}

TEST_F(LensMemoryTest, GivesWhatALookWouldGive) {
  resolved(R"({"camera": {"eye_mm": [400, 0, 0]}})");
  EXPECT_EQ(resolved(kOpenLens), resolve_scene(Json::parse(kOpenLens), facts, {640, 480}));
}

TEST_F(LensMemoryTest, LooksAgainForWhateverTheLensDependsOn) {
  resolved(kOpenLens);
  for (const char* other :
       {R"({"camera": {"eye_mm": [400, 0, 0]}})",
        R"({"context": {"surface": {"iso_value": -100}}})",
        R"({"focus": {"surface": {"iso_value": 300}}})", R"({"lens": {"radius_mm": 20}})"}) {
    lenses.take_searches();
    resolved(other);
    EXPECT_EQ(lenses.take_searches(), 1) << other;
  }
  resolved(kOpenLens);
  lenses.take_searches();
  resolved(kOpenLens, {480, 640});
  EXPECT_EQ(lenses.take_searches(), 1) << "another viewport";
  facts.id = "another ball";
  resolved(kOpenLens, {480, 640});
  EXPECT_EQ(lenses.take_searches(), 1) << "another volume";
}

TEST_F(LensMemoryTest, LooksForNothingThatTheSceneSays) {
  resolved(R"({"lens": {"centre_mm": [1, 2, 3], "radius_mm": 20}})");
  EXPECT_EQ(lenses.take_searches(), 0);
}

TEST_F(LensMemoryTest, LooksForNothingOfASceneThatIsRefused) {
  EXPECT_THROW(resolved(R"({"light": {"direction": [0, 0, 0]}})"), Error);
  EXPECT_EQ(lenses.take_searches(), 0);
}

}  // namespace
}  // namespace cutaway
