// One run of the child process that isolated_reader.h speaks of, from its job to its end.
#pragma once

#include <functional>
#include <optional>

#include "import/isolation/child_process.h"
#include "import/isolation/isolated_reader.h"
#include "import/isolation/worker_protocol.h"
#include "import/refusal.h"

namespace cutaway::reading {

/// Of program, libraries and headers.
inline constexpr std::uint64_t kBaseMemoryBytes = std::uint64_t{1} << 30;

/// What a child leaves behind.
struct Outcome {
  std::optional<Json> answer;          ///< its last report: a volume or a listing
  std::optional<std::string> failure;  ///< in words, where it did not end well
};

/// What one child may take of memory: within its address space, and outside of it by writing.
struct MemoryLimits {
  std::uint64_t address_space_bytes = 0;
  std::uint64_t voxel_bytes = 0;
};

/// Listens to a child until it ends. `on_report` gets its reports but for errors, which are thrown.
Outcome supervise(const IsolatedReader& isolation, const Json& job, const MemoryLimits& memory,
                  const Descriptor& voxels, const std::function<void(const Json&)>& on_report,
                  const std::stop_token& stop);

inline constexpr const char* kUnusableAnswer = "its reader's answer is not usable";

/// An answer in no form that we know is a failure of the file's, not of ours.
template <typename Work>
auto with_field(const std::filesystem::path& file, Work work) {
  try {
    return work();
  } catch (const Json::exception&) {
    refuse(file, kUnusableAnswer);
  } catch (const Error& error) {
    Error::Detail detail = error.detail();
    if (!detail.field.empty()) throw;
    detail.field = file.string();
    throw Error(detail);
  }
}

}  // namespace cutaway::reading
