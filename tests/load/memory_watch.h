// The memory of another process over time.
#pragma once

#include <optional>
#include <vector>

namespace cutaway::load {

struct MemorySample {
  double at_s = 0.0;  ///< on the run's clock
  double mib = 0.0;   ///< resident (VmRSS)
};

/// Resident memory now, MiB; nothing where there is no such process.
std::optional<double> resident_mib(int pid);

}  // namespace cutaway::load
