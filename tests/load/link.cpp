#include "load/link.h"

#include <algorithm>

namespace cutaway::load {

namespace {

constexpr std::size_t kUnlimitedChunk = std::size_t{64} * 1024;
constexpr double kChunkTime_s = 0.002;
constexpr double kBufferTime_s = 0.02;
constexpr std::chrono::milliseconds kReady{2};    // a read that takes less found bytes waiting
constexpr std::chrono::milliseconds kMadeUp{20};  // at most, for a reader that wakes late

}  // namespace

std::size_t SimulatedLink::chunk_bytes() const {
  if (!limited()) return kUnlimitedChunk;
  const double bytes = kChunkTime_s * static_cast<double>(settings_.bytes_per_second);
  return static_cast<std::size_t>(std::clamp(bytes, 256.0, 65536.0));
}

int SimulatedLink::receive_buffer_bytes() const {
  if (!limited()) return 0;
  const double bytes = kBufferTime_s * static_cast<double>(settings_.bytes_per_second);
  return static_cast<int>(std::clamp(bytes, 8192.0, 4e6));
}

TimePoint SimulatedLink::transferred(std::size_t bytes, TimePoint asked, TimePoint now) {
  if (!limited()) return now;
  const Seconds time(static_cast<double>(bytes) / static_cast<double>(settings_.bytes_per_second));
  const TimePoint begun = now - asked < kReady ? now - kMadeUp : now;
  free_at_ = std::max(free_at_, begun) + std::chrono::ceil<Clock::duration>(time);
  return free_at_;
}

Clock::duration SimulatedLink::delay() const {
  return std::chrono::round<Clock::duration>(
      std::chrono::duration<double, std::milli>(settings_.delay_ms));
}

}  // namespace cutaway::load
