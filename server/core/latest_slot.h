// One place for one value: a newer value replaces an older one that nobody has taken yet.
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace cutaway {

/// Thread-safe; never blocks for longer than a move.
template <typename T>
class LatestSlot {
 public:
  /// Returns the value that was waiting and is now replaced, if there was one.
  std::optional<T> put(T value) {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, std::optional<T>(std::move(value)));
  }

  std::optional<T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<T> value_;
};

}  // namespace cutaway
