#include "import/isolation/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "core/error.h"
#include "core/progress.h"
#include "import/isolation/worker_protocol.h"

namespace cutaway::reading {

namespace {

[[noreturn]] void fail(const char* what, int error) {
  throw Error({.code = ErrorCode::internal, .message = what, .received = std::strerror(error)});
}

int checked(int result, const char* what) {
  if (result < 0) fail(what, errno);
  return result;
}

/// Above the numbers that the child's own descriptors get, so that none overwrites another on the
/// way.
Descriptor moved_up(const Descriptor& from) {
  constexpr int kFirstFree = 10;
  return Descriptor(
      checked(fcntl(from.get(), F_DUPFD_CLOEXEC, kFirstFree), "a descriptor cannot be copied"));
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  void give(const Descriptor& ours, int theirs) {
    posix_spawn_file_actions_adddup2(&actions_, ours.get(), theirs);
  }
  void silence(int theirs) {
    posix_spawn_file_actions_addopen(&actions_, theirs, "/dev/null", O_WRONLY, 0);
  }
  void close_from(int first) { posix_spawn_file_actions_addclosefrom_np(&actions_, first); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The child's signals do what they do by themselves, whatever this process ignores, and none that
/// a terminal sends to all who hang on it reaches the child: its end is for us to say.
class Attributes {
 public:
  Attributes() {
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// Never above what binds this process, which it may have no right to lift.
void set_limit(pid_t pid, __rlimit_resource resource, rlim_t value, rlim_t hard_excess = 0) {
  constexpr const char* kUnset = "a reader's limits cannot be set";
  rlimit inherited{};
  checked(prlimit(pid, resource, nullptr, &inherited), kUnset);
  const rlim_t hard = std::min(value + hard_excess, inherited.rlim_max);
  const rlimit limit{std::min(value, hard), hard};
  checked(prlimit(pid, resource, &limit, nullptr), kUnset);
}

void apply_limits(pid_t pid, const ChildLimits& limits) {
  set_limit(pid, RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__  // whose shadow memory takes terabytes of address space
  if (limits.address_space_bytes > 0) set_limit(pid, RLIMIT_AS, limits.address_space_bytes);
#endif
  // Pages of a memory file that it only writes to are no part of its address space.
  if (limits.file_bytes > 0) set_limit(pid, RLIMIT_FSIZE, limits.file_bytes);
  if (limits.processor_time.count() > 0) {
    // The soft limit sends SIGXCPU, which tells itself apart; the hard one SIGKILL.
    set_limit(pid, RLIMIT_CPU, static_cast<rlim_t>(limits.processor_time.count()), 5);
  }
}

/// False where `patience` has passed, without a byte of it or its end. Throws Cancelled.
bool await(const Descriptor& awaited, std::chrono::milliseconds patience,
           const std::stop_token& stop) {
  const Descriptor stopped(checked(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "no event can be made"));
  const std::stop_callback wake(stop, [&stopped] { eventfd_write(stopped.get(), 1); });
  std::array<pollfd, 2> waiting{{{awaited.get(), POLLIN, 0}, {stopped.get(), POLLIN, 0}}};
  int ready = 0;
  do {
    ready = poll(waiting.data(), waiting.size(), static_cast<int>(patience.count()));
  } while (ready < 0 && errno == EINTR);
  throw_if_cancelled(stop);
  return checked(ready, "a reader cannot be waited for") > 0;
}

/// Becomes readable with the end of the process. By number: the C library's header of it is not
/// made for C++ everywhere.
int process_descriptor(pid_t pid) { return static_cast<int>(syscall(SYS_pidfd_open, pid, 0)); }

}  // namespace

void Descriptor::reset() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Descriptor make_memory_file(const char* name) {
  return Descriptor(checked(memfd_create(name, MFD_CLOEXEC), "no memory file can be made"));
}

// By way of the other constructor, so that what throws here leaves no child behind.
ChildProcess::ChildProcess(const std::vector<std::string>& command, const Descriptor& input,
                           const Descriptor& output, const ChildLimits& limits)
    : ChildProcess() {
  std::array<int, 2> ends{};
  checked(pipe2(ends.data(), O_CLOEXEC), "no pipe can be made");
  reports_ = Descriptor(ends[0]);
  const Descriptor report_end = moved_up(Descriptor(ends[1]));
  const Descriptor input_end = moved_up(input);
  const Descriptor output_end = moved_up(output);
  FileActions actions;
  actions.give(input_end, STDIN_FILENO);
  actions.silence(STDOUT_FILENO);
  actions.silence(STDERR_FILENO);
  actions.give(report_end, kReportDescriptor);
  actions.give(output_end, kVoxelDescriptor);
  actions.close_from(kVoxelDescriptor + 1);
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int error = posix_spawn(&pid_, arguments[0], actions.get(), Attributes().get(),
                                arguments.data(), environ);
  if (error != 0) {
    pid_ = -1;
    fail("the reader's process cannot be started", error);
  }
  apply_limits(pid_, limits);
  fcntl(reports_.get(), F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  kill();
  if (pid_ > 0) wait();
}

ChildProcess::Heard ChildProcess::next_line(std::string& line, std::chrono::milliseconds patience,
                                            const std::stop_token& stop) {
  while (!take_line(line)) {
    if (!await(reports_, patience, stop)) return Heard::silence;
    std::array<char, 65536> piece{};
    const ssize_t got = ::read(reports_.get(), piece.data(), piece.size());
    if (got == 0) return Heard::end;
    if (got <= 0) continue;
    buffer_.erase(0, taken_);
    taken_ = 0;
    buffer_.append(piece.data(), static_cast<std::size_t>(got));
  }
  return Heard::line;
}

bool ChildProcess::take_line(std::string& line) {
  constexpr std::size_t kLongestLine = std::size_t{64} << 20;
  const std::size_t end = buffer_.find('\n', taken_);
  if (end == std::string::npos) {
    if (buffer_.size() - taken_ > kLongestLine) {
      throw Error({.code = ErrorCode::volume_refused, .message = "a reader's report is too long"});
    }
    return false;
  }
  line = buffer_.substr(taken_, end - taken_);
  taken_ = end + 1;
  return true;
}

std::optional<ChildEnd> ChildProcess::wait_for(std::chrono::milliseconds patience,
                                               const std::stop_token& stop) {
  const Descriptor process(checked(process_descriptor(pid_), "a reader cannot be waited for"));
  if (!await(process, patience, stop)) return std::nullopt;
  return wait();
}

ChildEnd ChildProcess::wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status)) return {.exit_status = 0, .signal = WTERMSIG(status)};
  return {.exit_status = WEXITSTATUS(status), .signal = 0};
}

void ChildProcess::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

}  // namespace cutaway::reading
