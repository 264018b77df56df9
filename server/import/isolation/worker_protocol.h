// What passes between the server and the child process that reads a file for it: a job as JSON on
// the child's standard input, reports as lines of JSON on descriptor 3, voxels in the shared memory
// file of descriptor 4. What a child says is checked like any other input: it may have been taken
// over by the file it read.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/progress.h"
#include "import/reader.h"

namespace cutaway::reading {

using Json = nlohmann::json;

inline constexpr int kReportDescriptor = 3;
inline constexpr int kVoxelDescriptor = 4;

/// Everything of a volume but its voxels, of which it has the kind.
struct VolumeHead {
  Volume volume;
  bool is_float = false;
};

enum class ScanTask {
  list,         ///< what there is
  list_opened,  ///< of files that did no harm; the others are refused unopened
  try_out,      ///< opens the others, and lists nothing
};

struct ScanJob {
  std::filesystem::path path;
  std::filesystem::path root;
  std::uint64_t volume_bytes = 0;
  ScanTask task = ScanTask::list;
  std::map<std::filesystem::path, std::string> given_up;  ///< with the reason to say
  std::set<std::filesystem::path> opened;                 ///< by an earlier child, without harm
  std::optional<std::string> dicom_refused;               ///< no series are to be looked for
};

Json to_json(const ScanJob& job);
Json to_json(const VolumeSource& source);
Json to_json(const Listing& listing);
Json to_json(const Error& error);
Json to_json(const VolumeHead& head);
Json progress_report(LoadStage stage, double fraction);

/// All throw nlohmann::json::exception or Error for what is not in the form of their counterpart.
ScanJob scan_job_from(const Json& json);
VolumeSource source_from(const Json& json);
Listing listing_from(const Json& json);
Error error_from(const Json& json);
VolumeHead volume_head_from(const Json& json);
std::pair<LoadStage, double> progress_from(const Json& json);

std::vector<std::filesystem::path> paths_from(const Json& json);

/// The job's and the reports' text; bytes that are no UTF-8 are replaced.
std::string text_of(const Json& json);

}  // namespace cutaway::reading
