// One step of the pipeline, run again only when what it reads has changed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "render/frame_plan.h"

namespace cutaway {

/// `Key` holds everything that the stage's output depends on, with the versions of the stages
/// before it. Must stay where it is while a plan has its pass.
template <typename Key>
class Stage {
 public:
  /// Adds the passes, of which the last one's `done` is the stage's to set, to the plan unless the
  /// output already belongs to `key`. Returns the version that the output has once the plan is
  /// done.
  std::uint64_t schedule(Key key, FramePlan& plan, std::vector<Pass> passes) {
    if (key_ == key) return runs_;
    key_.reset();  // a plan that is given up leaves no output that could pass for either
    passes.back().done = [this, key = std::move(key)] { key_ = key; };
    for (Pass& pass : passes) plan.add(std::move(pass));
    return ++runs_;
  }

  std::uint64_t schedule(Key key, FramePlan& plan, Pass pass) {
    std::vector<Pass> passes;
    passes.push_back(std::move(pass));
    return schedule(std::move(key), plan, std::move(passes));
  }

  std::uint64_t runs() const { return runs_; }

 private:
  std::optional<Key> key_;
  std::uint64_t runs_ = 0;
};

}  // namespace cutaway
