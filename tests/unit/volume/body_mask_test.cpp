// What is body and what is couch, on CTs of known truth.
#include "volume/facts/body_mask.h"

#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "support/made_ct.h"
#include "volume/prepared/preparation.h"

namespace cutaway {
namespace {

using test::MadeCt;
using test::MadePlace;
using Place = std::function<MadePlace(glm::dvec3)>;

VolumeGeometry bed_geometry() { return test::centred_geometry({128, 92, 64}, {2.5, 2.5, 2.5}); }

struct Shares {
  double body_kept;    ///< of the body's voxels denser than skin
  double couch_taken;  ///< of the couch's
};

Shares after_hiding(const MadeCt& made) {
  const auto loaded = derive_loaded_volume(made.volume, {}, {});
  const auto seen = prepare(*loaded, {.hide_couch = true}, {});
  constexpr double kSkin = -300.0;
  double body = 0.0, kept = 0.0, couch = 0.0, taken = 0.0;
  const glm::ivec3 size = made.volume.geometry.size_voxels;
  for (std::size_t i = 0; i < made.body.size(); ++i) {
    const glm::ivec3 at(int(i % size.x), int(i / size.x % size.y), int(i / size.x / size.y));
    const double before = value_at(made.volume, at);
    if (before <= kSkin) continue;
    const bool is_kept = value_at(seen->volume, at) == before;
    body += made.body[i];
    kept += made.body[i] != 0 && is_kept ? 1.0 : 0.0;
    couch += made.couch[i];
    taken += made.couch[i] != 0 && !is_kept ? 1.0 : 0.0;
  }
  return {kept / body, couch > 0.0 ? taken / couch : 1.0};
}

void expect_parted(const Place& place, const VolumeGeometry& geometry = bed_geometry()) {
  const Shares shares = after_hiding(test::made_ct(geometry, 20.0, place));
  EXPECT_GE(shares.body_kept, 0.999);
  EXPECT_GE(shares.couch_taken, 0.98);
}

TEST(BodyMask, LeavesOutACouchFiveMillimetresOff) {
  expect_parted(test::any_of({test::made_torso, test::made_couch(5.0, 20.0)}));
}

// Flattened by it: nothing is in two places.
TEST(BodyMask, LeavesOutACouchThatTheBodyLiesOn) {
  expect_parted(test::any_of({test::made_couch(-6.0, 20.0), test::made_torso}));
  expect_parted(test::any_of({test::made_couch(-4.0, 8.0), test::made_torso}));
}

TEST(BodyMask, LeavesOutAHollowCouch) {
  const Place hollow = [](glm::dvec3 p) {
    MadePlace here = test::made_couch(-3.0, 36.0)(p);
    const double depth_mm = p.y - 72.0;
    if (here.is_couch && depth_mm > 6.0 && depth_mm < 30.0) here.hu = -930.0;
    return here;
  };
  expect_parted(test::any_of({hollow, test::made_torso}));
}

/// A head, and arms beside it that meet nothing within the volume.
TEST(BodyMask, KeepsRaisedArms) {
  const Place arms = [](glm::dvec3 p) {
    const glm::dvec2 from_arm(std::abs(p.x) - 110.0, p.y);
    if (glm::length(from_arm) < 38.0) return MadePlace{.hu = 40.0, .is_body = true};
    if (glm::length(glm::dvec2(p.x, p.y)) < 60.0) return MadePlace{.hu = 40.0, .is_body = true};
    return MadePlace{};
  };
  expect_parted(test::any_of({arms, test::made_couch(5.0, 15.0)}));
}

/// Of which the field of view shows but the upper 14 mm.
TEST(BodyMask, LeavesOutACouchThatTheBoxCuts) {
  expect_parted(test::any_of({test::made_torso, test::made_couch(5.0, 40.0)}),
                test::centred_geometry({128, 76, 64}, {2.5, 2.5, 2.5}));
}

TEST(BodyMask, LeavesOutAHeadrest) {
  const Place head = [](glm::dvec3 p) {
    if (glm::length(p / glm::dvec3(70.0, 90.0, 95.0)) < 1.0)
      return MadePlace{.hu = 40.0, .is_body = true};
    const bool is_nose = glm::length(p - glm::dvec3(0.0, -94.0, 0.0)) < 10.0;
    return is_nose ? MadePlace{.hu = 30.0, .is_body = true} : MadePlace{};
  };
  const Place rest = [](glm::dvec3 p) {
    const double around = glm::length(p / glm::dvec3(70.0, 90.0, 95.0));
    const bool holds = p.y > 20.0 && around > 1.06 && around < 1.17 && std::abs(p.z) < 60.0;
    return holds ? MadePlace{.hu = 0.0, .is_couch = true} : MadePlace{};
  };
  expect_parted(test::any_of({head, rest}), test::centred_geometry({96, 108, 96}, {2.2, 2.2, 2.2}));
}

TEST(BodyMask, KeepsBothOfTwoParts) {
  const Place legs = [](glm::dvec3 p) {
    const glm::dvec2 from_leg(std::abs(p.x) - 65.0, p.y - 25.0);
    if (glm::length(from_leg) < 14.0) return MadePlace{.hu = 800.0, .is_body = true};
    return glm::length(from_leg) < 50.0 ? MadePlace{.hu = 30.0, .is_body = true} : MadePlace{};
  };
  expect_parted(test::any_of({legs, test::made_couch(5.0, 15.0)}));
}

TEST(BodyMask, KeepsTheBodyInAGridOfThickSlices) {
  expect_parted(test::any_of({test::made_torso, test::made_couch(6.0, 20.0)}),
                test::centred_geometry({320, 230, 20}, {1.0, 1.0, 8.0}));
}

TEST(BodyMask, IsNoneWhereTheVolumeIsCutWithinTheBody) {
  const MadeCt made =
      test::made_ct(test::centred_geometry({20, 16, 20}, {2.0, 2.0, 2.0}), 20.0,
                    [](glm::dvec3 p) { return test::made_torso(p + glm::dvec3(0.0, 25.0, 0.0)); });
  EXPECT_EQ(derive_loaded_volume(made.volume, {}, {})->findings.body, nullptr);
}

TEST(BodyMask, FillsLungsSliceBySlice) {
  const MadeCt made = test::made_ct(bed_geometry(), 20.0, test::made_torso);
  const auto loaded = derive_loaded_volume(made.volume, {}, {});
  ASSERT_NE(loaded->findings.body, nullptr);
  EXPECT_FALSE(loaded->findings.has_couch());
  std::size_t lost = 0;
  for (std::size_t i = 0; i < made.body.size(); ++i)
    lost += made.body[i] != 0 && loaded->findings.body->body[i] == 0 ? 1 : 0;
  EXPECT_LE(double(lost), 0.001 * double(made.body.size()));
}

TEST(Prepare, FillsTheBodyAndLeavesItsSkin) {
  const MadeCt made = test::made_ct(bed_geometry(), 20.0, test::made_torso);
  const auto loaded = derive_loaded_volume(made.volume, {}, {});
  const auto seen = prepare(*loaded, {.filled_with = -25.0}, {});
  const glm::ivec3 lung(64 + 20, 44, 32);
  EXPECT_LT(value_at(loaded->volume, lung), -700.0);
  EXPECT_NEAR(value_at(seen->volume, lung), -25.0, 1.0);
  const glm::ivec3 outside(2, 2, 2);
  EXPECT_EQ(value_at(seen->volume, outside), value_at(loaded->volume, outside));
  const glm::ivec3 spine(64, 46 + 18, 32);
  EXPECT_EQ(value_at(seen->volume, spine), value_at(loaded->volume, spine));
}

TEST(Prepare, DropsIslandsAndKeepsTheRest) {
  const auto field = [](glm::dvec3 p) {
    if (glm::length(p) < 12.0) return 700.0;
    if (glm::length(p - glm::dvec3(22.0, 0.0, 0.0)) < 3.0) return 650.0;
    return 0.0;
  };
  const auto loaded =
      derive_loaded_volume(test::sampled_volume(test::centred_geometry(64), field), {}, {});
  VolumePreparation preparation;
  preparation.islands[1] = IslandLimit{{.lower = 250.0}, 0.5};
  const auto seen = prepare(*loaded, preparation, {});
  EXPECT_NEAR(sample(loaded->volume, {53.5, 31.5, 31.5}), 650.0, 1.0);
  EXPECT_LE(sample(seen->volume, {53.5, 31.5, 31.5}), 250.0);
  EXPECT_NEAR(sample(seen->volume, {31.5, 31.5, 31.5}), 700.0, 1.0);
  preparation.islands[1]->smallest_ml = 100.0;  // all are smaller: nothing would be left
  EXPECT_NEAR(sample(prepare(*loaded, preparation, {})->volume, {53.5, 31.5, 31.5}), 650.0, 1.0);
}

}  // namespace
}  // namespace cutaway
