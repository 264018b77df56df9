#include "load/memory_watch.h"

#include <fstream>
#include <string>

namespace cutaway::load {

std::optional<double> resident_mib(int pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  while (status >> word) {
    if (word != "VmRSS:") continue;
    double kib = 0.0;
    if (status >> kib) return kib / 1024.0;
  }
  return std::nullopt;
}

}  // namespace cutaway::load
