// What a child of the server starts with.
#include "import/isolation/child_process.h"

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <string>

#include "core/error.h"
#include "core/progress.h"

namespace cutaway::reading {
namespace {

/// What a shell command says on the pipe for reports.
std::string said_by(const std::string& command) {
  const Descriptor input = make_memory_file("input");
  const Descriptor output = make_memory_file("output");
  ChildProcess child({"/bin/sh", "-c", command + " >&3"}, input, output, {});
  std::string all;
  for (std::string line;
       child.next_line(line, std::chrono::seconds(60), {}) == ChildProcess::Heard::line;) {
    all += line + "\n";
  }
  return all;
}

/// For as long as it stands this process ignores a signal.
class Ignored {
 public:
  explicit Ignored(int signal) : signal_(signal), before_(::signal(signal, SIG_IGN)) {}
  ~Ignored() { ::signal(signal_, before_); }
  Ignored(const Ignored&) = delete;
  Ignored& operator=(const Ignored&) = delete;

 private:
  int signal_;
  sighandler_t before_;
};

TEST(ChildProcess, ItsSignalsDoWhatTheyDoByThemselves) {
  const Ignored pipe(SIGPIPE);
  const Ignored hang_up(SIGHUP);
  const std::string masks = said_by("exec grep -E '^Sig(Blk|Ign)' /proc/self/status");
  unsigned long blocked = 0;
  unsigned long ignored = 0;
  ASSERT_EQ(std::sscanf(masks.c_str(), "SigBlk: %lx SigIgn: %lx", &blocked, &ignored), 2) << masks;
  constexpr unsigned long kStandardSignals = 0x7fffffff;  // above are the C library's own
  EXPECT_EQ(blocked & kStandardSignals, 0) << masks;
  EXPECT_EQ(ignored & kStandardSignals, 0) << masks;
}

TEST(ChildProcess, WhatATerminalSendsToItsForegroundDoesNotReachIt) {
  const std::string statistics = said_by("exec cat /proc/self/stat");
  // PID (NAME) STATE PARENT GROUP
  const std::size_t after_name = statistics.rfind(") ");
  int parent = 0;
  int group = 0;
  ASSERT_EQ(std::sscanf(statistics.c_str() + after_name, ") %*c %d %d", &parent, &group), 2);
  EXPECT_EQ(parent, getpid());
  EXPECT_EQ(group, std::stoi(statistics));
}

/// One that said all it has to say, and goes on.
class Lingering : public testing::Test {
 protected:
  void SetUp() override {
    std::string line;
    ASSERT_EQ(child_.next_line(line, std::chrono::minutes(1), {}), ChildProcess::Heard::end);
  }

  Descriptor input_ = make_memory_file("input");
  ChildProcess child_{{"/bin/sh", "-c", "exec 3>&-; exec sleep 600"}, input_, input_, {}};
};

TEST_F(Lingering, IsNotWaitedForBeyondPatience) {
  EXPECT_FALSE(child_.wait_for(std::chrono::milliseconds(10), {}));
  child_.kill();
  const auto end = child_.wait_for(std::chrono::minutes(1), {});
  ASSERT_TRUE(end);
  EXPECT_EQ(end->signal, SIGKILL);
}

TEST_F(Lingering, IsNotWaitedForAfterAStop) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(child_.wait_for(std::chrono::minutes(1), stop.get_token()), Cancelled);
}

/// From here on the system refuses this process to set limits.
bool forbid_limits() {
  std::array<sock_filter, 4> program{
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_prlimit64, 0, 1),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog filter{program.size(), program.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

enum Ending { no_child_left = 10, child_left, ran_without_limits, not_forbidden };

/// Without its limits it would be no safer than this process.
Ending start_where_limits_are_forbidden() {
  if (!forbid_limits()) return not_forbidden;
  const Descriptor input = make_memory_file("input");
  try {
    ChildProcess({"/bin/sh", "-c", "sleep 60"}, input, input, {.file_bytes = 1});
  } catch (const Error&) {
    return ::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD ? no_child_left : child_left;
  }
  return ran_without_limits;
}

TEST(ChildProcess, DoesNotRunWhereItsLimitsCannotBeSet) {
  const pid_t process = fork();
  if (process == 0) _exit(start_where_limits_are_forbidden());
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == not_forbidden) GTEST_SKIP() << "no seccomp filters here";
  EXPECT_EQ(WEXITSTATUS(status), no_child_left);
}

}  // namespace
}  // namespace cutaway::reading
