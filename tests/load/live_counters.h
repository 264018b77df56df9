// What the progress line shows while the clients run; any thread.
#pragma once

#include <atomic>
#include <cstdint>

namespace cutaway::load {

struct LiveCounters {
  std::atomic<int> connected{0};
  std::atomic<int> showing{0};  ///< have had a frame
  std::atomic<int> ended{0};
  std::atomic<std::uint64_t> frames{0};
  std::atomic<std::uint64_t> bytes{0};
  std::atomic<std::uint64_t> errors{0};
  std::atomic<std::uint64_t> stale{0};
};

}  // namespace cutaway::load
