// Loading volumes: shared, cancelled, bounded; on small phantoms.
#include "app/volume_service.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <condition_variable>
#include <filesystem>
#include <fstream>

#include "scene/schema.h"

namespace cutaway {
namespace {

constexpr std::chrono::seconds kGenerous{60};
constexpr int kLargestEdge = 512;

/// Has no device to put anything on, and so is done at once.
UploadTarget no_renderer() {
  return {.largest_edge_voxels = kLargestEdge,
          .upload = [](const auto&, const ProgressSink& progress, const std::stop_token&) {
            progress(LoadStage::upload, 1.0);
          }};
}

/// Uploads go on until the test lets them end.
class SlowRenderer {
 public:
  UploadTarget target() {
    return {.largest_edge_voxels = kLargestEdge,
            .upload = [this](const auto&, const ProgressSink& progress, std::stop_token stop) {
              upload(progress, std::move(stop));
            }};
  }
  void let_end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

 private:
  void upload(const ProgressSink& progress, std::stop_token stop) {
    progress(LoadStage::upload, 0.25);
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, stop, [this] { return ended_; })) throw Cancelled();
    progress(LoadStage::upload, 1.0);
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool ended_ = false;
};

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
  Error error() { return std::get<Error>(outcome()); }
  void wait_for_progress() {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kGenerous, [this] { return !stages_.empty(); }));
  }
  void wait_for_stage(LoadStage stage) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(
        lock, kGenerous, [this, stage] { return !stages_.empty() && stages_.back() == stage; }));
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
  const VolumeService service{VolumeSettings{}, no_renderer()};
  const Json listing = service.listing();
  validate(listing, "volumes");
  std::vector<std::string> ids;
  for (const Json& volume : listing["volumes"]) ids.push_back(volume["id"]);
  EXPECT_THAT(ids, ::testing::ElementsAre("phantom:head", "phantom:abdomen", "phantom:knees"));
}

TEST(VolumeService, LoadsAPhantomThroughAllStages) {
  VolumeService service{VolumeSettings{}, no_renderer()};
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
  VolumeService service{VolumeSettings{}, no_renderer()};
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
  VolumeService service{VolumeSettings{}, no_renderer()};
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
  VolumeService service{VolumeSettings{}, no_renderer()};
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
  VolumeService service{VolumeSettings{.load_threads = 4}, no_renderer()};
  std::array<Heard, 4> heard;
  std::vector<std::unique_ptr<OpenTicket>> tickets;
  for (Heard& each : heard) {
    tickets.push_back(service.open("phantom:head@64", each.progress(), each.done()));
  }
  const auto first = heard[0].volume();
  for (Heard& each : heard) EXPECT_EQ(each.volume(), first);
}

TEST(VolumeService, WhatIsLoadedIsNotLoadedAgain) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard first;
  Heard second;
  const auto one = service.open("phantom:head@32", first.progress(), first.done());
  const auto volume = first.volume();
  const auto two = service.open("phantom:head@32", second.progress(), second.done());
  EXPECT_EQ(second.volume(), volume);
  EXPECT_TRUE(second.stages().empty());
}

TEST(VolumeService, AWithdrawnWishHearsNothingAndTheOthersDo) {
  VolumeService service{VolumeSettings{}, no_renderer()};
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
  VolumeService service{VolumeSettings{.load_threads = 1}, no_renderer()};
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
  VolumeService service{VolumeSettings{}, no_renderer()};
  for (const char* id :
       {"nowhere", "", "../../etc/passwd", "phantom:unicorn", "phantom:head@9999"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    EXPECT_THAT(heard.error_code(), ::testing::AnyOf("unknown-volume", "out-of-range")) << id;
  }
}

TEST(VolumeService, AskingForWhatThereIsNotLeavesTheLogAlone) {
  ::testing::internal::CaptureStderr();
  VolumeService service{VolumeSettings{}, no_renderer()};
  for (const char* id : {"nowhere\nat all", "phantom:unicorn", "phantom:head@9999"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    heard.outcome();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// 64^3 voxels are announced as floats, 1 MiB, and stored as half of that.
TEST(VolumeService, KeepsAsManyAsFitAndDropsTheLeastRecentlyUsed) {
  VolumeService service{VolumeSettings{.memory_bytes = 2'000'000}, no_renderer()};
  for (const char* id : {"phantom:head@64", "phantom:abdomen@64", "phantom:knees@64"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    heard.volume();
  }
  EXPECT_EQ(service.loaded("phantom:head@64"), nullptr);
  EXPECT_NE(service.loaded("phantom:knees@64"), nullptr);
}

TEST(VolumeService, WhatIsShownIsNotDroppedAndANewOneIsRefused) {
  VolumeService service{VolumeSettings{.memory_bytes = 1'300'000}, no_renderer()};
  Heard shown;
  const auto ticket = service.open("phantom:head@64", shown.progress(), shown.done());
  const auto held = shown.volume();
  Heard refused;
  const auto other = service.open("phantom:knees@64", refused.progress(), refused.done());
  EXPECT_EQ(refused.error_code(), "too-large");
  EXPECT_NE(service.loaded("phantom:head@64"), nullptr);
}

TEST(VolumeService, AFolderThatCannotBeScannedIsListedWithItsReason) {
  VolumeService service{VolumeSettings{.data = {"/nowhere/at/all"}}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("anything", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), "unknown-volume");  // answered once the scan has ended
  ASSERT_EQ(service.listing()["refused"].size(), 1);
  EXPECT_EQ(service.listing()["refused"][0]["path"], "all");
  EXPECT_THAT(service.listing().dump(), ::testing::Not(::testing::HasSubstr("/nowhere")));
}

TEST(VolumeService, AVolumeIsThereOnlyOnceItIsUploaded) {
  SlowRenderer renderer;
  VolumeService service{VolumeSettings{}, renderer.target()};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  heard.wait_for_stage(LoadStage::upload);
  EXPECT_EQ(heard.outcomes(), 0);
  EXPECT_EQ(service.loaded("phantom:head@32"), nullptr);
  renderer.let_end();
  EXPECT_NE(heard.volume(), nullptr);
  EXPECT_NE(service.loaded("phantom:head@32"), nullptr);
}

TEST(VolumeService, AnUploadIsCancelledWhenTheLastOneGoes) {
  SlowRenderer renderer;
  VolumeService service{VolumeSettings{.load_threads = 1}, renderer.target()};
  Heard gone;
  auto ticket = service.open("phantom:head@32", gone.progress(), gone.done());
  gone.wait_for_stage(LoadStage::upload);
  ticket.reset();
  Heard next;  // the one thread is free again
  const auto other = service.open("phantom:knees@32", next.progress(), next.done());
  next.wait_for_stage(LoadStage::upload);
  renderer.let_end();
  EXPECT_NE(next.volume(), nullptr);
  EXPECT_EQ(gone.outcomes(), 0);
  EXPECT_EQ(service.loaded("phantom:head@32"), nullptr);
}

TEST(VolumeService, WhatTheRendererCannotHoldIsRefusedBeforeAVoxelIsRead) {
  UploadTarget small = no_renderer();
  small.largest_edge_voxels = 48;
  VolumeService service{VolumeSettings{}, small};
  Heard heard;
  const auto ticket = service.open("phantom:head@64", heard.progress(), heard.done());
  const Error::Detail refusal = heard.error().detail();
  EXPECT_EQ(refusal.code, "volume-refused");
  EXPECT_EQ(refusal.field, "/volume");
  EXPECT_EQ(refusal.expected, "at most 48 voxels an edge");
  EXPECT_EQ(refusal.received, "64");
  EXPECT_TRUE(heard.stages().empty());
}

TEST(VolumeService, AFailedUploadFailsTheLoadAndLeavesNothingBehind) {
  bool full = true;
  UploadTarget target = no_renderer();
  target.upload = [&full](const auto&, const auto&, const auto&) {
    if (full) throw Error({.code = "too-large", .message = "the device is full"});
  };
  // Room for one: what a failed load had set aside is free again.
  VolumeService service{VolumeSettings{.memory_bytes = 1'300'000}, target};
  Heard refused;
  const auto ticket = service.open("phantom:head@64", refused.progress(), refused.done());
  EXPECT_EQ(refused.error().detail().code, "too-large");
  EXPECT_EQ(refused.error().detail().field, "/volume");
  EXPECT_EQ(refused.error().detail().received, "phantom:head@64");
  EXPECT_EQ(service.loaded("phantom:head@64"), nullptr);
  full = false;
  Heard heard;
  const auto other = service.open("phantom:knees@64", heard.progress(), heard.done());
  EXPECT_NE(heard.volume(), nullptr);
}

TEST(VolumeService, RunningOutOfMemoryIsTheLoadsOwnMisfortune) {
  UploadTarget target = no_renderer();
  target.upload = [](const auto&, const auto&, const auto&) { throw std::bad_alloc(); };
  VolumeService service{VolumeSettings{}, target};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), "too-large");
}

#ifdef CUTAWAY_IMPORT
/// A folder of this test's own, gone with it.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("cutaway-" + name + "-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_ / "inner");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
  }

 private:
  std::filesystem::path path_;
};

constexpr const char* kVolume =
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678";

TEST(VolumeService, NeverSaysWhereFilesLie) {
  const Folder folder("paths");
  folder.write("inner/good.nrrd", kVolume);
  folder.write("inner/short.nrrd", std::string(kVolume).substr(0, 66));
  VolumeService service{VolumeSettings{.data = {folder.path()}}, no_renderer()};
  Heard scanned;
  const auto scan = service.open("not there", scanned.progress(), scanned.done());
  EXPECT_EQ(scanned.error_code(), "unknown-volume");
  const Json listing = service.listing();
  ASSERT_EQ(listing["refused"].size(), 1);
  ASSERT_EQ(listing["volumes"].size(), 4);  // the phantoms, too
  EXPECT_EQ(listing["refused"][0]["path"], "inner/short.nrrd");
  EXPECT_THAT(listing.dump(), ::testing::Not(::testing::HasSubstr(folder.path().string())));
  const std::string id = listing["volumes"][0]["id"];
  folder.write("inner/good.nrrd", "something else now");
  Heard heard;
  const auto ticket = service.open(id, heard.progress(), heard.done());
  EXPECT_EQ(heard.error().detail().field, "/volume");
  EXPECT_THAT(heard.error().what(), ::testing::Not(::testing::HasSubstr(folder.path().string())));
}

/// A program that answers as a reader of volumes does after so long.
std::filesystem::path slow_reader(const Folder& folder, const std::string& seconds) {
  folder.write("reader", "#!/bin/sh\nsleep " + seconds + "\n");
  std::filesystem::permissions(folder.path() / "reader", std::filesystem::perms::owner_all);
  return folder.path() / "reader";
}

TEST(VolumeService, WhoWaitsForTheScanHoldsUpNobody) {
  const Folder folder("slow-scan");
  VolumeService service{
      VolumeSettings{
          .data = {folder.path()}, .load_threads = 1, .reader = slow_reader(folder, "1000")},
      no_renderer()};
  std::array<Heard, 3> waiting;
  std::vector<std::unique_ptr<OpenTicket>> tickets;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    tickets.push_back(
        service.open("file" + std::to_string(i), waiting[i].progress(), waiting[i].done()));
  }
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  EXPECT_NE(heard.volume(), nullptr);
  for (Heard& each : waiting) EXPECT_EQ(each.outcomes(), 0);
}

TEST(VolumeService, SaysWhetherItStillLooksForVolumes) {
  EXPECT_EQ((VolumeService{VolumeSettings{}, no_renderer()}.listing()["scanning"]), false);
  const Folder folder("scanning");
  VolumeService service{
      VolumeSettings{.data = {folder.path()}, .reader = slow_reader(folder, "0.3")}, no_renderer()};
  EXPECT_EQ(service.listing()["scanning"], true);
  validate(service.listing(), "volumes");
  Heard heard;
  const auto ticket = service.open("file", heard.progress(), heard.done());
  heard.outcome();  // at the scan's end
  EXPECT_EQ(service.listing()["scanning"], false);
}

TEST(VolumeService, WhoWaitsForTheScanIsAnsweredAtItsEnd) {
  const Folder folder("end-of-scan");
  VolumeService service{
      VolumeSettings{.data = {folder.path()}, .reader = slow_reader(folder, "0.3")}, no_renderer()};
  Heard heard;
  const auto ticket = service.open("file", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), "unknown-volume");
}

TEST(VolumeService, FindsAndOpensARealVolume) {
  const char* data = std::getenv("CUTAWAY_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "CUTAWAY_TEST_DATA is not set";
  const auto folder = std::filesystem::path(data) / "head_mr_seg3d_nii";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  VolumeService service{VolumeSettings{.data = {folder}}, no_renderer()};
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
