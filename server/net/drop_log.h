// One line a second of the log for what a flood of clients makes happen thousands of times.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace cutaway {

/// Thread-safe.
class DropLog {
 public:
  /// `what` happened to `peer`.
  void note(const std::string& what, const std::string& peer);
  /// Logs each thing that was noted since, how often, and to whom last. To be called once a second.
  void flush();

 private:
  struct Happened {
    std::uint64_t times = 0;
    std::string last_peer;
  };

  std::mutex mutex_;
  std::map<std::string, Happened> happened_;
};

}  // namespace cutaway
