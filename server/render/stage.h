// One step of the pipeline, run again only when what it reads has changed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "render/frame_plan.h"

namespace cutaway {

/// `Key` holds everything that the stage's output depends on, with the versions of the stages
/// before it. Must stay where it is while a plan has its pass.
template <typename Key>
class Stage {
 public:
  /// Adds the pass, whose `done` is the stage's to set, to the plan unless the output already
  /// belongs to `key`. Returns the version that the output has once the plan is done.
  std::uint64_t schedule(Key key, FramePlan& plan, Pass pass) {
    if (key_ == key) return runs_;
    key_.reset();  // a plan that is given up leaves no output that could pass for either
    pass.done = [this, key = std::move(key)] { key_ = key; };
    plan.add(std::move(pass));
    return ++runs_;
  }

  std::uint64_t runs() const { return runs_; }

 private:
  std::optional<Key> key_;
  std::uint64_t runs_ = 0;
};

}  // namespace cutaway
