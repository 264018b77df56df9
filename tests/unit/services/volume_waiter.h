// A service of volumes without a renderer, and what those who wait for it hear.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "services/volume_service.h"

namespace cutaway::testing {

inline constexpr std::chrono::seconds kGenerous{300};
inline constexpr int kLargestEdge = 512;

/// Has no device to put anything on, and so is done at once.
inline UploadTarget no_renderer() {
  return {.largest_edge_voxels = kLargestEdge,
          .upload = [](const auto&, const ProgressSink& progress, const std::stop_token&) {
            progress(LoadStage::upload, 1.0);
          }};
}

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
  ErrorCode error_code() { return std::get<Error>(outcome()).detail().code; }
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

}  // namespace cutaway::testing
