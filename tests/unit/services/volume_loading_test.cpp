// Loads: shared, cancelled, bounded; on small phantoms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/services/volume_waiter.h"

namespace cutaway {
namespace {

using testing::Heard;
using testing::kLargestEdge;
using testing::no_renderer;

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
    if (!changed_.wait(lock, std::move(stop), [this] { return ended_; })) throw Cancelled();
    progress(LoadStage::upload, 1.0);
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool ended_ = false;
};

TEST(VolumeLoading, OneLoadServesAllWhoWait) {
  VolumeService service{VolumeSettings{.load_threads = 4}, no_renderer()};
  std::array<Heard, 4> heard;
  std::vector<std::unique_ptr<OpenTicket>> tickets;
  tickets.reserve(heard.size());
  for (Heard& each : heard) {
    tickets.push_back(service.open("phantom:head@64", each.progress(), each.done()));
  }
  const auto first = heard[0].volume();
  for (Heard& each : heard) EXPECT_EQ(each.volume(), first);
}

TEST(VolumeLoading, WhatIsLoadedIsNotLoadedAgain) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard first;
  Heard second;
  const auto one = service.open("phantom:head@32", first.progress(), first.done());
  const auto volume = first.volume();
  const auto two = service.open("phantom:head@32", second.progress(), second.done());
  EXPECT_EQ(second.volume(), volume);
  EXPECT_TRUE(second.stages().empty());
}

TEST(VolumeLoading, AWithdrawnWishHearsNothingAndTheOthersDo) {
  VolumeService service{VolumeSettings{}, no_renderer()};
  Heard withdrawn;
  Heard staying;
  auto leaving = service.open("phantom:head@96", withdrawn.progress(), withdrawn.done());
  const auto ticket = service.open("phantom:head@96", staying.progress(), staying.done());
  leaving.reset();
  EXPECT_NE(staying.volume(), nullptr);
  EXPECT_EQ(withdrawn.outcomes(), 0);
}

TEST(VolumeLoading, TheLoadIsCancelledWhenTheLastOneGoes) {
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

// 64^3 voxels are announced as floats, 1 MiB, and stored as half of that.
TEST(VolumeLoading, KeepsAsManyAsFitAndDropsTheLeastRecentlyUsed) {
  VolumeService service{VolumeSettings{.memory_bytes = 2'000'000}, no_renderer()};
  for (const char* id : {"phantom:head@64", "phantom:abdomen@64", "phantom:knees@64"}) {
    Heard heard;
    const auto ticket = service.open(id, heard.progress(), heard.done());
    heard.volume();
  }
  EXPECT_EQ(service.loaded("phantom:head@64"), nullptr);
  EXPECT_NE(service.loaded("phantom:knees@64"), nullptr);
}

TEST(VolumeLoading, WhatIsShownIsNotDroppedAndANewOneIsRefused) {
  VolumeService service{VolumeSettings{.memory_bytes = 1'300'000}, no_renderer()};
  Heard shown;
  const auto ticket = service.open("phantom:head@64", shown.progress(), shown.done());
  const auto held = shown.volume();
  Heard refused;
  const auto other = service.open("phantom:knees@64", refused.progress(), refused.done());
  EXPECT_EQ(refused.error_code(), ErrorCode::too_large);
  EXPECT_NE(service.loaded("phantom:head@64"), nullptr);
}

TEST(VolumeLoading, AVolumeIsThereOnlyOnceItIsUploaded) {
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

TEST(VolumeLoading, AnUploadIsCancelledWhenTheLastOneGoes) {
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

TEST(VolumeLoading, AFailedUploadFailsTheLoadAndLeavesNothingBehind) {
  bool full = true;
  UploadTarget target = no_renderer();
  target.upload = [&full](const auto&, const auto&, const auto&) {
    if (full) throw Error({.code = ErrorCode::too_large, .message = "the device is full"});
  };
  // Room for one: what a failed load had set aside is free again.
  VolumeService service{VolumeSettings{.memory_bytes = 1'300'000}, target};
  Heard refused;
  const auto ticket = service.open("phantom:head@64", refused.progress(), refused.done());
  EXPECT_EQ(refused.error().detail().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().detail().field, "/volume");
  EXPECT_EQ(refused.error().detail().received, "phantom:head@64");
  EXPECT_EQ(service.loaded("phantom:head@64"), nullptr);
  full = false;
  Heard heard;
  const auto other = service.open("phantom:knees@64", heard.progress(), heard.done());
  EXPECT_NE(heard.volume(), nullptr);
}

TEST(VolumeLoading, RunningOutOfMemoryIsTheLoadsOwnMisfortune) {
  UploadTarget target = no_renderer();
  target.upload = [](const auto&, const auto&, const auto&) { throw std::bad_alloc(); };
  VolumeService service{VolumeSettings{}, target};
  Heard heard;
  const auto ticket = service.open("phantom:head@32", heard.progress(), heard.done());
  EXPECT_EQ(heard.error_code(), ErrorCode::too_large);
}

}  // namespace
}  // namespace cutaway
