// A point in the stream of commands that can be waited for.
#pragma once

#include <utility>

#include "gl/handle.h"

namespace cutaway::gl {

/// On the thread whose context is current.
class Fence {
 public:
  Fence() = default;
  /// Behind everything that was asked for so far; the device is told to begin with it.
  static Fence insert();

  bool is_set() const { return sync_ != nullptr; }
  /// Whether the device has come to it; never waits.
  bool is_reached() const;
  /// Waits until it has, or until the device is lost.
  void wait() const;

  Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
  Fence& operator=(Fence&& other) noexcept {
    std::swap(sync_, other.sync_);
    return *this;
  }
  ~Fence();

 private:
  GLsync sync_ = nullptr;
};

}  // namespace cutaway::gl
