#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "import/isolation/isolated_reader.h"
#include "import/isolation/supervision.h"

namespace cutaway {

using namespace reading;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

/// At files that stopped a child; then the scan leaves those alone that were not opened yet.
constexpr std::chrono::minutes kMostTimeLost{10};

/// Names that a child reports: a limit only for one that was taken over.
constexpr std::size_t kMostBytesOfNames = std::size_t{256} << 20;

/// It has none to hand over.
constexpr std::uint64_t kVoxelBytesOfScan = std::uint64_t{1} << 20;

/// A scan that outlives its children. The first lists what there is. Where one breaks off at a
/// file, others only open what none has opened yet, each from where the one before it ended; when
/// they are through, a last one lists what did no harm. So a header is read twice at most, however
/// many files are broken, and no file costs the others their place in the listing.
class IsolatedScan {
 public:
  IsolatedScan(const IsolatedReader& isolation, const fs::path& path, const fs::path& data_root,
               const ImportLimits& limits, std::stop_token stop)
      : isolation_(isolation),
        path_(path),
        data_root_(data_root),
        limits_(limits),
        stop_(std::move(stop)) {}

  Listing run() {
    while (!is_hopeless()) {
      const Outcome outcome = run_child();
      if (outcome.failure) {
        note_failure(*outcome.failure);
      } else if (task_ == ScanTask::try_out) {
        task_ = ScanTask::list;
      } else {
        return completed(listing_from(outcome.answer.value_or(Json::object()).at("listing")));
      }
    }
    return completed({});
  }

 private:
  Outcome run_child() {
    const Descriptor unused = make_memory_file("cutaway-scan");
    const MemoryLimits memory{
        isolation_.memory_bytes > 0 ? isolation_.memory_bytes : 4 * kBaseMemoryBytes,
        kVoxelBytesOfScan};
    current_.clear();
    is_grouping_ = false;
    last_report_ = Clock::now();
    try {
      return supervise(
          isolation_, to_json(job()), memory, unused,
          [this](const Json& report) { note_report(report); }, stop_);
    } catch (const Json::exception&) {
      return {.answer = {}, .failure = kUnusableAnswer};
    }
  }

  ScanJob job() const {
    return {path_, data_root_, limits_.volume_bytes, task_, given_up_, opened_, dicom_refused_};
  }

  void note_report(const Json& report) {
    last_report_ = Clock::now();
    is_grouping_ = report.contains("grouping");
    if (report.contains("file")) current_ = report.at("file").get<std::string>();
    if (report.contains("opened")) remember_opened(report.at("opened").get<std::string>());
  }

  void remember_opened(const std::string& file) {
    if (bytes_of_names_ + file.size() > kMostBytesOfNames) return;
    if (opened_.insert(file).second) bytes_of_names_ += file.size();
  }

  void note_failure(const std::string& words) {
    ++failures_;
    time_lost_ += Clock::now() - last_report_;
    if (is_grouping_ && !dicom_refused_) {
      dicom_refused_ = words + ", while it sorted DICOM slices into volumes";
      task_ = ScanTask::list;
      return;
    }
    if (current_.empty()) refuse(path_, words);  // no file is to blame
    given_up_[current_] = words;
    task_ = leaves_rest_alone() ? ScanTask::list_opened : ScanTask::try_out;
  }

  bool leaves_rest_alone() const {
    return failures_ >= isolation_.failures_of_scan || time_lost_ >= kMostTimeLost;
  }

  /// Even with what was opened without harm before.
  bool is_hopeless() const {
    return failures_ >= 2 * isolation_.failures_of_scan || time_lost_ >= 2 * kMostTimeLost;
  }

  /// With the files given up, also where no child came to name them.
  Listing completed(Listing listing) const {
    std::set<fs::path> named;
    for (const auto& refused : listing.refused) named.insert(refused.path);
    for (const auto& [file, reason] : given_up_) {
      if (!named.contains(file)) listing.refused.push_back({file, reason});
    }
    return listing;
  }

  const IsolatedReader& isolation_;
  const fs::path& path_;
  const fs::path& data_root_;
  const ImportLimits& limits_;
  std::stop_token stop_;

  ScanTask task_ = ScanTask::list;
  std::map<fs::path, std::string> given_up_;
  std::set<fs::path> opened_;
  std::optional<std::string> dicom_refused_;
  std::size_t bytes_of_names_ = 0;
  std::size_t failures_ = 0;
  Clock::duration time_lost_{0};

  fs::path current_;  ///< the file that the child is at, or was at last
  bool is_grouping_ = false;
  Clock::time_point last_report_;
};

}  // namespace

Listing scan_volumes_isolated(const IsolatedReader& isolation, const fs::path& path,
                              const fs::path& data_root, const ImportLimits& limits,
                              std::stop_token stop) {
  return with_field(path, [&] {
    return IsolatedScan(isolation, path, data_root, limits, std::move(stop)).run();
  });
}

}  // namespace cutaway
