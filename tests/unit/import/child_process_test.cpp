// What a child of the server starts with.
#include "import/isolation/child_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <string>

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

}  // namespace
}  // namespace cutaway::reading
