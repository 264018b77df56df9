#include "import/isolation/import_worker.h"

#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>

#include "core/process.h"
#include "import/isolation/voxel_transfer.h"
#include "import/isolation/worker_protocol.h"
#include "import/scan.h"

namespace cutaway {

using namespace reading;

namespace {

/// Dies with its parent, gains no rights, and is the first to go where memory runs out. One arena
/// for all threads: each arena of its own would reserve address space, of which there is a limit.
void keep_harmless() {
  mallopt(M_ARENA_MAX, 1);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
  forbid_core_dumps();  // last: of such a process that file is root's
}

void report(const char* kind, const Json& content) {
  const std::string line = text_of({{kind, content}}) + "\n";
  write_all(kReportDescriptor, std::as_bytes(std::span(line)));
}

/// As often as a bar is seen to move: each report is drawn by every page that waits.
class ThrottledProgress {
 public:
  void operator()(LoadStage stage, double fraction) {
    const auto now = Clock::now();
    if (stage == stage_ && fraction < 1.0 && now < reported_ + kInterval) return;
    stage_ = stage;
    reported_ = now;
    report("progress", progress_report(stage, fraction));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kInterval{50};

  LoadStage stage_ = LoadStage::read;
  Clock::time_point reported_;
};

void read_for(const Json& job, const ImportLimits& limits) {
  VolumeHead head{read_volume(source_from(job.at("read")), limits, ThrottledProgress(), {}), false};
  head.is_float = std::holds_alternative<std::vector<float>>(head.volume.voxels);
  std::visit([](auto& voxels) { hand_over(std::move(voxels), kVoxelDescriptor); },
             head.volume.voxels);
  report("volume", to_json(head));
}

void scan_for(const Json& job, const ImportLimits& limits) {
  ScanJob scan = scan_job_from(job);
  ScanContext context;
  context.limits = limits;
  context.given_up = std::move(scan.given_up);
  context.opened = std::move(scan.opened);
  context.only_opened = scan.task == ScanTask::list_opened;
  context.is_trial = scan.task == ScanTask::try_out;
  context.dicom_refused = std::move(scan.dicom_refused);
  context.on_file = [](const std::filesystem::path& file) { report("file", file.string()); };
  context.on_opened = [](const std::filesystem::path& file) { report("opened", file.string()); };
  context.on_grouping = [] { report("grouping", true); };
  report("listing", to_json(scan_in_context(scan.path, scan.root, std::move(context))));
}

}  // namespace

int run_import_worker() {
  keep_harmless();
  try {
    const std::string text{std::istreambuf_iterator<char>(std::cin),
                           std::istreambuf_iterator<char>()};
    const Json job = Json::parse(text);
    const ImportLimits limits{.volume_bytes = job.at("volume_bytes")};
    job.contains("scan") ? scan_for(job, limits) : read_for(job, limits);
  } catch (const Error& error) {
    report("error", to_json(error));
  } catch (const std::exception& error) {
    report("error", to_json(Error({.code = ErrorCode::volume_refused, .message = error.what()})));
  }
  return 0;
}

}  // namespace cutaway
