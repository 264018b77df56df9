// A process of our own that may crash, hang or be overrun without harm to this one.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace cutaway::reading {

/// Owns a file descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }
  int get() const { return number_; }
  void reset();

 private:
  int number_ = -1;
};

/// An anonymous file in memory, closed on exec. Throws Error where the system refuses.
Descriptor make_memory_file(const char* name);

/// Where this process itself is bound by less, so is the child.
struct ChildLimits {
  std::uint64_t address_space_bytes = 0;   ///< 0: none
  std::uint64_t file_bytes = 0;            ///< of each file that it writes, `output` too; 0: none
  std::chrono::seconds processor_time{0};  ///< 0: none
};

/// How it ended: by itself with a status, or by a signal.
struct ChildEnd {
  int exit_status = 0;
  int signal = 0;
};

class ChildProcess {
 public:
  /// Starts `command` with `input` as standard input, standard output and error thrown away, a pipe
  /// for reports on descriptor 3, `output` on descriptor 4, and no other descriptor of this
  /// process; it is killed with the thread that started it. Throws Error.
  ChildProcess(const std::vector<std::string>& command, const Descriptor& input,
               const Descriptor& output, const ChildLimits& limits);
  ~ChildProcess();  ///< kills it where it still runs
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  enum class Heard { line, end, silence };

  /// Waits for the next line of the report pipe, for its end, or until `patience` has passed
  /// without a byte. Throws Cancelled when stopped, Error for a line beyond 64 MiB.
  Heard next_line(std::string& line, std::chrono::milliseconds patience,
                  const std::stop_token& stop);

  /// Waits for its end, or for `patience`. Throws Cancelled when stopped.
  std::optional<ChildEnd> wait_for(std::chrono::milliseconds patience, const std::stop_token& stop);
  void kill();

 private:
  ChildProcess() = default;
  bool take_line(std::string& line);
  ChildEnd wait();

  pid_t pid_ = -1;
  Descriptor reports_;
  std::string buffer_;
  std::size_t taken_ = 0;  ///< of the buffer, as lines
};

}  // namespace cutaway::reading
