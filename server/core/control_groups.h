// What the control groups that a process is in let it have: those of containers and of services.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cutaway {

/// The least memory limit in bytes of this process' group and of all that it lies in (MemoryMax,
/// MemoryHigh of systemd; versions 1 and 2); nothing where none has a limit. `root`: of the file
/// system with /proc and /sys, for tests.
std::optional<std::uint64_t> control_group_memory_bytes(const std::filesystem::path& root = "/");

}  // namespace cutaway
