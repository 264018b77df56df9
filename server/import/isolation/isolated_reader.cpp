#include "import/isolation/isolated_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "import/decode_memory.h"
#include "import/isolation/supervision.h"
#include "import/isolation/voxel_transfer.h"
#include "import/refusal.h"

namespace cutaway {

using namespace reading;
namespace fs = std::filesystem;

namespace {

/// A voxel passes through at most 32 bytes on its way: as in the file, as decoded, resampled,
/// packed. Files are read whole; and some are decoded beside the voxels, within a limit that holds
/// whatever the child that scanned the file has said.
std::uint64_t memory_for(const VolumeSource& source, const ImportLimits& limits) {
  const glm::ivec3 size = source.geometry.size_voxels;
  std::uint64_t bytes = kBaseMemoryBytes + std::uint64_t(size.x) * size.y * size.z * 32;
  bytes += decode_memory_bytes(std::min(source.decode_bytes, limits.volume_bytes));
  for (const auto& file : source.files) {
    std::error_code failed;
    const auto file_bytes = fs::file_size(file, failed);
    if (!failed) bytes += 2 * file_bytes;
  }
  return bytes;
}

/// Beyond the limit by what a byte in the file may become, so that too many voxels are told apart
/// from those without end.
std::uint64_t voxel_bytes_for(const ImportLimits& limits) {
  constexpr std::uint64_t kLargestVoxel = sizeof(float);
  constexpr std::uint64_t kMargin = 4096;
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return std::min(limits.volume_bytes, (kMost - kMargin) / kLargestVoxel) * kLargestVoxel + kMargin;
}

Volume take_volume(VolumeHead head, const Descriptor& file, const ImportLimits& limits) {
  Volume volume = std::move(head.volume);
  const glm::ivec3 size = volume.geometry.size_voxels;
  const std::size_t count = std::size_t(size.x) * size.y * size.z;
  // A byte a voxel in the file may become a float here.
  if (count > limits.volume_bytes)
    throw Error({.code = ErrorCode::too_large, .message = "its reader delivered too many voxels"});
  if (!head.is_float) {
    volume.voxels = take_over<std::uint16_t>(file, count);
    return volume;
  }
  auto voxels = take_over<float>(file, count);
  if (!std::all_of(voxels.begin(), voxels.end(), [](float v) { return std::isfinite(v); })) {
    throw Error({.code = ErrorCode::volume_refused,
                 .message = "its reader delivered values that are no numbers"});
  }
  volume.voxels = std::move(voxels);
  return volume;
}

}  // namespace

Volume read_volume_isolated(const IsolatedReader& isolation, const VolumeSource& source,
                            const ImportLimits& limits, const ProgressSink& progress,
                            std::stop_token stop) {
  const fs::path& file = source.files.at(0);
  return with_field(file, [&] {
    const Descriptor voxels = make_memory_file("cutaway-voxels");
    const Json job = {{"read", to_json(source)}, {"volume_bytes", limits.volume_bytes}};
    const MemoryLimits memory{
        isolation.memory_bytes > 0 ? isolation.memory_bytes : memory_for(source, limits),
        voxel_bytes_for(limits)};
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

}  // namespace cutaway
