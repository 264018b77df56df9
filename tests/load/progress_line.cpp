#include "load/progress_line.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace cutaway::load {

namespace {

constexpr int kLogEvery_s = 10;

class ProgressLine {
 public:
  ProgressLine(int clients, double seconds)
      : clients_(clients), seconds_(seconds), terminal_(isatty(STDERR_FILENO) != 0) {}

  void operator()(double now_s, const LiveCounters& now) {
    const double passed = now_s - last_s_;
    const std::uint64_t frames = now.frames;
    const std::uint64_t bytes = now.bytes;
    const bool log = terminal_ || static_cast<int>(std::lround(now_s)) % kLogEvery_s == 0;
    if (log && passed > 0.0 && now_s > 0.5) {
      std::fprintf(stderr,
                   "%s%5.0f of %.0f s  %d of %d connected, %d ended  %6.0f frames/s  %7.2f MB/s  "
                   "%llu errors  %llu stale%s",
                   terminal_ ? "\r\x1b[K" : "", now_s, seconds_, now.connected.load(), clients_,
                   now.ended.load(), static_cast<double>(frames - last_frames_) / passed,
                   static_cast<double>(bytes - last_bytes_) / passed / 1e6,
                   static_cast<unsigned long long>(now.errors.load()),
                   static_cast<unsigned long long>(now.stale.load()), terminal_ ? "" : "\n");
    }
    if (terminal_ && now.ended == clients_) std::fputs("\n", stderr);
    last_s_ = now_s;
    last_frames_ = frames;
    last_bytes_ = bytes;
  }

 private:
  int clients_;
  double seconds_;
  bool terminal_;
  double last_s_ = 0.0;
  std::uint64_t last_frames_ = 0;
  std::uint64_t last_bytes_ = 0;
};

}  // namespace

Progress progress_line(int clients, double seconds) { return ProgressLine(clients, seconds); }

}  // namespace cutaway::load
