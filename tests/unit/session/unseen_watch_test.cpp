// A picture that shows nothing says why: once, when it rests, and again when that is over.
#include "unit/session/session_fixture.h"

namespace cutaway::testing {
namespace {

class UnseenWatchTest : public SessionFixture {
 protected:
  UnseenWatchTest() {
    show_ball();
    strand->advance(Milliseconds(2000.0));
    client.texts.clear();
  }
  std::vector<std::string> told_codes() const {
    std::vector<std::string> codes;
    for (const Json& message : client.of_type("unseen")) {
      codes.push_back("-");
      for (const Json& reason : message["reasons"])
        codes.back() += " " + std::string(reason["code"]);
    }
    return codes;
  }
  std::uint32_t iso_value(double value) {
    return scene({{"focus", {{"surface", {{"iso_value", value}}}}}});
  }
};

using Codes = std::vector<std::string>;

TEST_F(UnseenWatchTest, SaysNothingOfAPictureThatShowsSomething) {
  iso_value(120.0);
  come_to_rest();
  strand->advance(Milliseconds(2000.0));
  EXPECT_EQ(told_codes(), Codes());
}

TEST_F(UnseenWatchTest, SaysOnceWhyAndOnceThatItIsOver) {
  for (int turn = 0; turn < 3; ++turn) {
    iso_value(5000.0);
    scene({{"background", {{"colour", {0.1 * turn, 0.2, 0.3}}}}});
    come_to_rest();
    strand->advance(Milliseconds(2000.0));
  }
  ASSERT_EQ(told_codes(), Codes{"- above-all-values"});
  const Json reason = client.last("unseen")["reasons"][0];
  EXPECT_EQ(reason["branch"], "focus");
  EXPECT_EQ(reason["value"], 5000.0);
  EXPECT_EQ(reason["limit"], 200.0);
  iso_value(120.0);
  come_to_rest();
  strand->advance(Milliseconds(2000.0));
  EXPECT_EQ(told_codes(), (Codes{"- above-all-values", "-"}));
}

TEST_F(UnseenWatchTest, WaitsForTheSceneToRest) {
  for (int turn = 0; turn < 20; ++turn) {
    iso_value(5000.0 + turn);
    strand->advance(Milliseconds(100.0));
    EXPECT_EQ(told_codes(), Codes());
  }
  strand->advance(Milliseconds(400.0));
  EXPECT_EQ(told_codes(), Codes{"- above-all-values"});
  EXPECT_EQ(client.last("unseen")["reasons"][0]["value"], 5019.0);
}

TEST_F(UnseenWatchTest, LooksOnceASecondAtTheMost) {
  iso_value(5000.0);
  strand->advance(Milliseconds(400.0));
  iso_value(120.0);
  strand->advance(Milliseconds(900.0));
  EXPECT_EQ(told_codes(), Codes{"- above-all-values"});
  strand->advance(Milliseconds(200.0));
  EXPECT_EQ(told_codes(), (Codes{"- above-all-values", "-"}));
}

/// A ball from end to end of the camera's way: the lens in its middle.
TEST_F(UnseenWatchTest, SaysThatTheLensLiesInsideOfTheMaterial) {
  scene({{"lens", {{"centre_mm", {0, 0, 0}}, {"radius_mm", 10}}}});
  come_to_rest();
  strand->advance(Milliseconds(2000.0));
  EXPECT_EQ(told_codes(), Codes{"- lens-covered"});
}

TEST_F(UnseenWatchTest, SaysNothingWhereOnlyASliceChanges) {
  iso_value(5000.0);
  strand->advance(Milliseconds(2000.0));
  client.texts.clear();
  scene({{"slices", {{"crosshair_mm", {1, 2, 3}}}}});
  strand->advance(Milliseconds(2000.0));
  EXPECT_EQ(told_codes(), Codes());
}

}  // namespace
}  // namespace cutaway::testing
