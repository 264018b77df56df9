#include "benchmark/machine.h"

#include <sched.h>

#include <fstream>

namespace cutaway::benchmark {

namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

int usable_cores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 0;
}

}  // namespace

Machine this_machine() {
  return {.processor = processor_name(),
          .cores = usable_cores(),
          .renderer = {},
          .compiler = "gcc " __VERSION__};
}

}  // namespace cutaway::benchmark
