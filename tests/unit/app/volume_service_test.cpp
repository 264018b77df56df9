// Loading volumes: shared, cancelled, bounded; on small phantoms.
#include "app/volume_service.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>

#include "scene/schema.h"

namespace cutaway {
namespace {

constexpr std::chrono::seconds kGenerous{60};

/// What one waiter heard, from whichever thread.
class Heard {
 public:
  ProgressSink progress() {
    return [this](LoadStage stage, double) {
      const std::lock_guard lock(mutex_);
      if (stages_.empty() || stages_.back() != stage) stages_.push_back(stage);
      changed_.notify_all();
    };
  }
  std::function<void(OpenOutcome)> done() {
    return [this](OpenOutcome outcome) {
      const std::lock_guard lock(mutex_);
      outcomes_.push_back(std::move(outcome));
      changed_.notify_all();
    };
  }
  OpenOutcome outcome() {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kGenerous, [this] { return !outcomes_.empty(); }));
    return outcomes_.at(0);
  }
  std::shared_ptr<const OpenVolume> volume() {
    return std::get<std::shared_ptr<const OpenVolume>>(outcome());
  }
  std::string error_code() { return std::get<Error>(outcome()).detail().code; }
  void wait_for_progress() {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kGenerous, [this] { return !stages_.empty(); }));
  }
  std::vector<LoadStage> stages() {
    const std::lock_guard lock(mutex_);
    return stages_;
  }
  std::size_t outcomes() {
    const std::lock_guard lock(mutex_);
    return outcomes_.size();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<LoadStage> stages_;
  std::vector<OpenOutcome> outcomes_;
};

TEST(VolumeService, ListsThePhantomsAsTheSchemaWants) {
  const VolumeService service{VolumeSettings{}};
  const Json listing = service.listing();
  validate(listing, "volumes");
  std::vector<std::string> ids;
  for (const Json& volume : listing["volumes"]) ids.push_back(volume["id"]);
  EXPECT_THAT(ids, ::testing::ElementsAre("phantom:head", "phantom:abdomen", "phantom:knees"));
}

TEST(VolumeService, LoadsAPhantomThroughAllStages) {
  VolumeService service{VolumeSettings{}};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  EXPECT_EQ(volume->facts().id, "phantom:head@32");
  EXPECT_EQ(volume->units(), "HU");
  EXPECT_EQ(heard.stages().back(), LoadStage::upload);
  EXPECT_THAT(heard.stages(), ::testing::Contains(LoadStage::min_max));
  EXPECT_NE(service.loaded("phantom:head@32"), nullptr);
  EXPECT_EQ(service.loaded("phantom:knees"), nullptr);
}

TEST(VolumeService, SaysWhatASceneMessageNeeds) {
  VolumeService service{VolumeSettings{}};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const Json summary = heard.volume()->summary();
  validate({{"type", "scene"}, {"revision", 1}, {"scene", Json::object()}, {"volume", summary}},
           "server-message");
  std::uint64_t voxels = 0;
  for (const Json& count : summary["histogram"]) voxels += count.get<std::uint64_t>();
  EXPECT_EQ(voxels, 32U * 32U * 32U);
}

TEST(VolumeService, KnowsTheValueInsideAndNothingOutside) {
  VolumeService service{VolumeSettings{}};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  const VolumeFacts& facts = volume->facts();
  const auto corner = volume->value_at(facts.bounds_minimum_mm);
  ASSERT_TRUE(corner.has_value());
  EXPECT_NEAR(*corner, -1000.0, 200.0);  // air around the head
  EXPECT_EQ(volume->value_at(facts.bounds_minimum_mm - glm::dvec3(1.0)), std::nullopt);
  EXPECT_EQ(volume->value_at(facts.bounds_maximum_mm + glm::dvec3(1.0)), std::nullopt);
}

TEST(VolumeService, FindsTheSkinWithARay) {
  VolumeService service{VolumeSettings{}};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  const auto volume = heard.volume();
  const VolumeFacts& facts = volume->facts();
  const glm::dvec3 centre = 0.5 * (facts.bounds_minimum_mm + facts.bounds_maximum_mm);
  const glm::dvec3 front = centre - glm::dvec3(0.0, facts.diagonal_mm, 0.0);
  const auto skin = facts.first_surface_mm(front, {0.0, 1.0, 0.0}, {facts.outer_iso_value});
  ASSERT_TRUE(skin.has_value());
  EXPECT_NEAR(volume->value_at(*skin).value(), facts.outer_iso_value, 50.0);
}

TEST(VolumeService, OneLoadServesAllWhoWait) {
  VolumeService service{VolumeSettings{.load_threads = 4}};
  std::array<Heard, 4> heard;
  std::vector<std::unique_ptr<OpenTicket>> tickets;
  for (Heard& each : heard) {
    tickets.push_back(service.open("phantom:head@64", each.progress(), each.done()));
  }
  const auto first = heard[0].volume();
  for (Heard& each : heard) EXPECT_EQ(each.volume(), first);
}

TEST(VolumeService, WhatIsLoadedIsNotLoadedAgain) {
  VolumeService service{VolumeSettings{}};
  Heard first;
  Heard second;
  const auto one = service.open("phantom:head@32", first.progress(), first.done());
  const auto volume = first.volume();
  const auto two = service.open("phantom:head@32", second.progress(), second.done());
  EXPECT_EQ(second.volume(), volume);
  EXPECT_TRUE(second.stages().empty());
}

TEST(VolumeService, AWithdrawnWishHearsNothingAndTheOthersDo) {
  VolumeService service{VolumeSettings{}};
  Heard withdrawn;
  Heard staying;
  auto leaving = service.open("phantom:head@96", withdrawn.progress(), withdrawn.done());
  const auto ticket = service.open("phantom:head@96", staying.progress(), staying.done());
  leaving.reset();
  EXPECT_NE(staying.volume(), nullptr);
  EXPECT_EQ(withdrawn.outcomes(), 0);
}

TEST(VolumeService, TheLoadIsCancelledWhenTheLastOneGoes) {
  // One thread: the second volume can only come once the first load has stopped. A phantom of 512^3
  // takes far longer than the limit for waiting, were it not cancelled.
  VolumeService service{VolumeSettings{.load_threads = 1}};
  Heard large;
  auto ticket = service.open("phantom:abdomen@512", large.progress(), large.done());
  large.wait_for_progress();
  ticket.reset();
  Heard small;
  const auto other = service.open("phantom:head@32", small.progress(), small.done());
  EXPECT_NE(small.volume(), nullptr);
  EXPECT_EQ(large.outcomes(), 0);
  EXPECT_EQ(service.loaded("phantom:abdomen@512"), nullptr);
}

TEST(VolumeService, UnknownVolumesAreRefused) {
  VolumeService service{VolumeSettings{}};
  for (const char* id :
       {"nowhere", "", "../../etc/passwd", "phantom:unicorn", "phantom:head@9999"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    EXPECT_THAT(heard.error_code(), ::testing::AnyOf("unknown-volume", "out-of-range")) << id;
  }
}

// 64^3 voxels are announced as floats, 1 MiB, and stored as half of that.
TEST(VolumeService, KeepsAsManyAsFitAndDropsTheLeastRecentlyUsed) {
  VolumeService service{VolumeSettings{.memory_bytes = 2'000'000}};
  for (const char* id : {"phantom:head@64", "phantom:abdomen@64", "phantom:knees@64"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    heard.volume();
  }
  EXPECT_EQ(service.loaded("phantom:head@64"), nullptr);
  EXPECT_NE(service.loaded("phantom:knees@64"), nullptr);
}

TEST(VolumeService, WhatIsShownIsNotDroppedAndANewOneIsRefused) {
  VolumeService service{VolumeSettings{.memory_bytes = 1'300'000}};
  Heard shown;
  const auto ticket = service.open("phantom:head@64", shown.progress(), shown.done());
  const auto held = shown.volume();
  Heard refused;
  const auto other = service.open("phantom:knees@64", refused.progress(), refused.done());
  EXPECT_EQ(refused.error_code(), "too-large");
  EXPECT_NE(service.loaded("phantom:head@64"), nullptr);
}

TEST(VolumeService, AFolderThatCannotBeScannedIsListedWithItsReason) {
  VolumeService service{VolumeSettings{.data = {"/nowhere/at/all"}}};
  Heard heard;
  const auto ticket = service.open("anything", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), "unknown-volume");  // answered once the scan has ended
  ASSERT_EQ(service.listing()["refused"].size(), 1);
  EXPECT_EQ(service.listing()["refused"][0]["path"], "/nowhere/at/all");
}

#ifdef CUTAWAY_IMPORT
TEST(VolumeService, FindsAndOpensARealVolume) {
  const char* data = std::getenv("CUTAWAY_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "CUTAWAY_TEST_DATA is not set";
  const auto folder = std::filesystem::path(data) / "head_mr_seg3d_nii";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  VolumeService service{VolumeSettings{.data = {folder}}};
  Heard scanned;
  const auto scan = service.open("not there", scanned.progress(), scanned.done());
  EXPECT_EQ(scanned.error_code(), "unknown-volume");
  const Json listing = service.listing();
  validate(listing, "volumes");
  const std::string id = listing["volumes"][0]["id"];
  Heard heard;
  const auto ticket = service.open(id, heard.progress(), heard.done());
  EXPECT_EQ(heard.volume()->summary()["size_voxels"], Json({160, 232, 160}));
}
#endif

}  // namespace
}  // namespace cutaway
