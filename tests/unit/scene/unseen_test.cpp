#include "scene/unseen.h"

#include <gtest/gtest.h>

#include "scene/resolve.h"
#include "scene/schema.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

std::vector<std::string> reasons(const Json& document, const VolumeFacts& facts = ball_facts()) {
  std::vector<std::string> found;
  for (const auto& reason :
       reasons_for_nothing(resolve_scene(document, facts, {640, 480}), facts)) {
    found.push_back(in_words(reason));
    EXPECT_NO_THROW(validate(unseen_message({reason}), "server-message")) << found.back();
  }
  return found;
}

void expect_one(const std::vector<std::string>& found, const std::string& part) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
}

TEST(ReasonsForNothing, AreNoneForWhatIsChosen) { EXPECT_TRUE(reasons(Json::object()).empty()); }

TEST(ReasonsForNothing, NameAnIsoValueBeyondAllValues) {
  expect_one(reasons({{"focus", {{"surface", {{"iso_value", 2000}}}}}}),
             "nothing of the focus can be seen: its iso-value, 2000.0, is above all values");
  expect_one(reasons({{"context", {{"surface", {{"iso_value", 5000}}}}}}),
             "nothing of the context");
  expect_one(reasons({{"context", {{"surface", {{"iso_value", -5000}}}}}}),
             "fills the whole volume");
  expect_one(reasons({{"focus", {{"surface", {{"iso_value", -9000}, {"upper_value", -5000}}}}}}),
             "is below all values");
}

TEST(ReasonsForNothing, NameALensInsideTheMaterial) {
  const Json centre = {kBallCentre_mm.x, kBallCentre_mm.y, kBallCentre_mm.z};
  expect_one(reasons({{"lens", {{"centre_mm", centre}, {"radius_mm", 20}}}}),
             "it lies inside of the context's material");
  EXPECT_TRUE(
      reasons({{"lens", {{"centre_mm", centre}, {"radius_mm", 20}, {"mode", "magic"}}}}).empty());
  EXPECT_TRUE(
      reasons({{"lens", {{"centre_mm", centre}, {"radius_mm", 20}, {"mode", "none"}}}}).empty());
}

TEST(ReasonsForNothing, NameALensWithoutFocus) {
  const Json surface = {kBallCentre_mm.x, kBallCentre_mm.y - kBallRadius_mm, kBallCentre_mm.z};
  expect_one(reasons({{"lens", {{"centre_mm", surface}, {"radius_mm", 5}}}}),
             "there is nothing of the focus in it");
}

TEST(ReasonsForNothing, NameAnOpacityThatIsTooLittleForTheVolume) {
  const Json document{{"context", {{"surface", {{"opacity", 0.05}}}}}};
  EXPECT_TRUE(reasons(document).empty());
  VolumeFacts tiny = ball_facts();
  tiny.diagonal_mm = 0.02;
  expect_one(reasons(document, tiny), "nothing of the context can be seen: an opacity of 0.05");
}

TEST(ReasonsForNothing, NameAnEmptyVolume) {
  VolumeFacts facts = ball_facts();
  facts.minimum_value = facts.maximum_value = 3.0;
  expect_one(reasons(Json::object(), facts), "the volume is empty: every voxel has the value 3");
}

}  // namespace
}  // namespace cutaway
