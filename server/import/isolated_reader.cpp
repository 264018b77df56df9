#include "import/isolated_reader.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

#include "import/child_process.h"
#include "import/refusal.h"
#include "import/worker_protocol.h"

namespace cutaway {

using namespace reading;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kBaseMemoryBytes = std::uint64_t{1} << 30;  // program, libraries, headers

/// A voxel passes through at most 32 bytes on its way: as in the file, as decoded, resampled,
/// packed. Files are read whole; and what is decoded beside the voxels is there four times at
/// worst, within a limit that holds whatever the child that scanned the file has said.
std::uint64_t memory_for(const VolumeSource& source, const ImportLimits& limits) {
  const glm::ivec3 size = source.geometry.size_voxels;
  std::uint64_t bytes = kBaseMemoryBytes + std::uint64_t(size.x) * size.y * size.z * 32;
  bytes += 4 * std::min(source.decode_bytes, limits.volume_bytes);
  for (const auto& file : source.files) {
    std::error_code failed;
    const auto file_bytes = fs::file_size(file, failed);
    if (!failed) bytes += 2 * file_bytes;
  }
  return bytes;
}

/// In a file of memory, which a child that does not read cannot block.
Descriptor job_file(const Json& job) {
  Descriptor file = make_memory_file("cutaway-job");
  const std::string text = text_of(job);
  if (pwrite(file.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    throw Error({.code = "internal", .message = "a reader's job cannot be written"});
  }
  return file;
}

/// What a child leaves behind.
struct Outcome {
  std::optional<Json> answer;          ///< its last report: a volume or a listing
  std::optional<std::string> failure;  ///< in words, where it did not end well
};

std::string failure_in_words(const ChildEnd& end, const IsolatedReader& isolation) {
  if (end.signal == SIGXCPU) {
    return fmt::format("reading it took more than {} s of processor time",
                       isolation.processor_time.count());
  }
  if (end.signal == SIGKILL) return "its reader was killed, perhaps for want of memory";
  if (end.signal != 0) return fmt::format("its reader crashed (signal {})", end.signal);
  return fmt::format("its reader ended without an answer (status {})", end.exit_status);
}

/// Listens to a child until it ends. `on_report` gets its reports but for errors, which are thrown.
Outcome supervise(const IsolatedReader& isolation, const Json& job, std::uint64_t memory_bytes,
                  const Descriptor& voxels, const std::function<void(const Json&)>& on_report,
                  const std::stop_token& stop) {
  std::vector<std::string> command{isolation.executable.string()};
  command.insert(command.end(), isolation.arguments.begin(), isolation.arguments.end());
  ChildProcess child(command, job_file(job), voxels, {memory_bytes, isolation.processor_time});
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
  const ChildEnd end = child.wait();
  if (end.signal != 0 || end.exit_status != 0) outcome.failure = failure_in_words(end, isolation);
  return outcome;
}

/// By reading, not mapping: the child could cut a mapped file under us.
template <typename T>
std::vector<T> take_voxels(const Descriptor& file, std::size_t count) {
  struct stat status {};
  const std::size_t bytes = count * sizeof(T);
  if (fstat(file.get(), &status) != 0 || static_cast<std::size_t>(status.st_size) != bytes) {
    throw Error(
        {.code = "volume-refused", .message = "its reader delivered another number of voxels"});
  }
  std::vector<T> voxels(count);
  const std::span target = std::as_writable_bytes(std::span(voxels));
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t got =
        pread(file.get(), target.data() + done, bytes - done, static_cast<off_t>(done));
    if (got <= 0)
      throw Error(
          {.code = "volume-refused", .message = "its reader's voxels cannot be taken over"});
    done += static_cast<std::size_t>(got);
  }
  return voxels;
}

Volume take_volume(VolumeHead head, const Descriptor& file, const ImportLimits& limits) {
  Volume volume = std::move(head.volume);
  const glm::ivec3 size = volume.geometry.size_voxels;
  const std::size_t count = std::size_t(size.x) * size.y * size.z;
  // A byte a voxel in the file may become a float here.
  if (count > limits.volume_bytes)
    throw Error({.code = "too-large", .message = "its reader delivered too many voxels"});
  if (!head.is_float) {
    volume.voxels = take_voxels<std::uint16_t>(file, count);
    return volume;
  }
  auto voxels = take_voxels<float>(file, count);
  if (!std::all_of(voxels.begin(), voxels.end(), [](float v) { return std::isfinite(v); })) {
    throw Error(
        {.code = "volume-refused", .message = "its reader delivered values that are no numbers"});
  }
  volume.voxels = std::move(voxels);
  return volume;
}

/// An answer in no form that we know is a failure of the file's, not of ours.
template <typename Work>
auto with_field(const fs::path& file, Work work) {
  try {
    return work();
  } catch (const Json::exception&) {
    refuse(file, "its reader's answer is not usable");
  } catch (const Error& error) {
    Error::Detail detail = error.detail();
    if (!detail.field.empty()) throw;
    detail.field = file.string();
    throw Error(detail);
  }
}

}  // namespace

Volume read_volume_isolated(const IsolatedReader& isolation, const VolumeSource& source,
                            const ImportLimits& limits, const ProgressSink& progress,
                            std::stop_token stop) {
  const fs::path& file = source.files.at(0);
  return with_field(file, [&] {
    const Descriptor voxels = make_memory_file("cutaway-voxels");
    const Json job = {{"read", to_json(source)}, {"volume_bytes", limits.volume_bytes}};
    const std::uint64_t memory =
        isolation.memory_bytes > 0 ? isolation.memory_bytes : memory_for(source, limits);
    const auto on_report = [&](const Json& report) {
      if (!progress || !report.contains("progress")) return;
      const auto [stage, fraction] = progress_from(report.at("progress"));
      progress(stage, fraction);
    };
    const Outcome outcome = supervise(isolation, job, memory, voxels, on_report, stop);
    if (outcome.failure) refuse(file, *outcome.failure);
    return take_volume(volume_head_from(outcome.answer.value_or(Json::object()).at("volume")),
                       voxels, limits);
  });
}

Listing scan_volumes_isolated(const IsolatedReader& isolation, const fs::path& path,
                              const fs::path& data_root, const ImportLimits& limits,
                              std::stop_token stop) {
  constexpr std::size_t kMostFailures = 100;
  return with_field(path, [&] {
    std::vector<RefusedFile> failed;
    Json skip = Json::array();
    while (true) {
      const Descriptor unused = make_memory_file("cutaway-scan");
      const Json job = {{"scan", path.string()},
                        {"root", data_root.string()},
                        {"skip", skip},
                        {"volume_bytes", limits.volume_bytes}};
      std::string current;  // the file at work, empty where there is none to blame
      bool grouping = false;
      const auto on_report = [&](const Json& report) {
        grouping = report.contains("grouping");
        current = report.contains("file") ? report.at("file").get<std::string>() : "";
      };
      const std::uint64_t memory =
          isolation.memory_bytes > 0 ? isolation.memory_bytes : 4 * kBaseMemoryBytes;
      const Outcome outcome = supervise(isolation, job, memory, unused, on_report, stop);
      if (!outcome.failure) {
        Listing listing = listing_from(outcome.answer.value_or(Json::object()).at("listing"));
        listing.refused.insert(listing.refused.end(), failed.begin(), failed.end());
        return listing;
      }
      if (grouping) refuse(path, *outcome.failure + " while it sorted DICOM slices into volumes");
      if (current.empty() || failed.size() == kMostFailures) refuse(path, *outcome.failure);
      failed.push_back({current, *outcome.failure});
      skip.push_back(current);
    }
  });
}

}  // namespace cutaway
