#include "import/isolation/supervision.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/log.h"

namespace cutaway::reading {

namespace {

/// From the end of its reports, which is near its own where all is well.
constexpr std::chrono::milliseconds kMostToEnd{5000};

/// In a file of memory, which a child that does not read cannot block.
Descriptor job_file(const Json& job) {
  Descriptor file = make_memory_file("cutaway-job");
  const std::string text = text_of(job);
  if (pwrite(file.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    throw Error({.code = ErrorCode::internal, .message = "a reader's job cannot be written"});
  }
  return file;
}

/// Numbers of signals and states are for the log; whose file it is gets words.
std::string failure_in_words(const ChildEnd& end, const IsolatedReader& isolation) {
  log().debug("a reader ended with status {}, signal {}", end.exit_status, end.signal);
  if (end.signal == SIGXCPU) {
    return fmt::format("reading it took more than {} s of processor time",
                       isolation.processor_time.count());
  }
  if (end.signal == SIGXFSZ) return "its reader wrote more than it may";
  if (end.signal == SIGKILL) return "its reader was killed, perhaps for want of memory";
  if (end.signal != 0) return "its reader broke down, as it does at damaged files";
  return "its reader ended without an answer";
}

}  // namespace

Outcome supervise(const IsolatedReader& isolation, const Json& job, const MemoryLimits& memory,
                  const Descriptor& voxels, const std::function<void(const Json&)>& on_report,
                  const std::stop_token& stop) {
  std::vector<std::string> command{isolation.executable.string()};
  command.insert(command.end(), isolation.arguments.begin(), isolation.arguments.end());
  ChildProcess child(command, job_file(job), voxels,
                     {memory.address_space_bytes, memory.voxel_bytes, isolation.processor_time});
  Outcome outcome;
  for (std::string line;;) {
    const auto heard = child.next_line(line, isolation.silence, stop);
    if (heard == ChildProcess::Heard::silence) {
      outcome.failure =
          fmt::format("its reader said nothing for {:.0f} s",
                      std::ceil(static_cast<double>(isolation.silence.count()) / 1000.0));
      return outcome;
    }
    if (heard == ChildProcess::Heard::end) break;
    Json report = Json::parse(line);
    if (report.contains("error")) throw error_from(report.at("error"));
    on_report(report);
    outcome.answer = std::move(report);
  }
  const auto end = child.wait_for(std::min(isolation.silence, kMostToEnd), stop);
  if (!end) {
    outcome.failure = "its reader did not end after its last word";
  } else if (end->signal != 0 || end->exit_status != 0) {
    outcome.failure = failure_in_words(*end, isolation);
  }
  return outcome;
}

}  // namespace cutaway::reading
