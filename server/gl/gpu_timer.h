// How long the device works on a stretch of commands.
#pragma once

#include <cstdint>

#include "gl/handle.h"

namespace cutaway::gl {

/// Timestamps at the begin and the end of a stretch; the answer comes later. On software renderers,
/// which draw when they are flushed, only stretches that end with a flush mean anything.
class GpuTimer {
 public:
  GpuTimer();
  void begin() const;
  void end() const;
  /// Waits for the device to reach the end.
  std::uint64_t elapsed_ns() const;

 private:
  QueryHandle begin_;
  QueryHandle end_;
};

}  // namespace cutaway::gl
