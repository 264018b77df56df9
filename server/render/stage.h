// One step of the pipeline, run again only when what it reads has changed.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

namespace cutaway {

/// `Key` holds everything that the stage's output depends on, with the versions of the stages
/// before it.
template <typename Key>
class Stage {
 public:
  /// Runs `work` unless the output already belongs to `key`. Returns the output's version.
  template <typename Work>
  std::uint64_t run(Key key, Work&& work) {
    if (key_ != key) {
      key_.reset();  // an exception leaves no output that could pass for either
      std::forward<Work>(work)();
      key_ = std::move(key);
      ++runs_;
    }
    return runs_;
  }

  std::uint64_t runs() const { return runs_; }

 private:
  std::optional<Key> key_;
  std::uint64_t runs_ = 0;
};

}  // namespace cutaway
