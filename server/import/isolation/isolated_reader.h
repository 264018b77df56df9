// reader.h's two functions, done by a child process: a file that crashes, hangs or bloats its
// decoder costs that process and no more.
#pragma once

#include <chrono>

#include "import/reader.h"

namespace cutaway {

struct IsolatedReader {
  /// One that answers by run_import_worker(); by default the program that is running.
  std::filesystem::path executable = "/proc/self/exe";
  std::vector<std::string> arguments{"read-volume-worker"};  ///< that make it do so
  std::uint64_t memory_bytes =
      0;  ///< address space of the child; 0: what a volume of that size needs, generously
  std::chrono::seconds processor_time{900};
  std::chrono::milliseconds silence{120'000};  ///< the longest that it may say nothing
  std::size_t failures_of_scan = 100;  ///< files that may stop it before the rest is left alone
};

/// As read_volume(). Error "volume-refused" also where the child crashed, was killed, exceeded a
/// limit or fell silent; stopping kills it. Throws Error "internal" where no child can be started.
/// Any thread.
Volume read_volume_isolated(const IsolatedReader& isolation, const VolumeSource& source,
                            const ImportLimits& limits, const ProgressSink& progress,
                            std::stop_token stop);

/// As scan_volumes(). A file at which the child crashed or fell silent is refused, and the scan
/// goes on behind it. Where that happens too often (`failures_of_scan`, or 10 minutes lost), files
/// that were not opened yet are refused as not looked at, and the rest is listed.
Listing scan_volumes_isolated(const IsolatedReader& isolation, const std::filesystem::path& path,
                              const std::filesystem::path& data_root, const ImportLimits& limits,
                              std::stop_token stop);

}  // namespace cutaway
