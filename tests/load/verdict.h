// Whether the thresholds of a script held.
#pragma once

#include <string>
#include <vector>

#include "load/script.h"
#include "load/summary.h"

namespace cutaway::load {

struct Check {
  std::string name;
  std::string expected;  ///< with its unit
  std::string measured;
  bool held = false;
};

/// One for each threshold that the script has, and for those that every run has. A threshold that
/// nothing was measured for has not held; only memory is not judged where it was not watched.
std::vector<Check> judge(const Thresholds& thresholds, const Summary& summary);

bool all_held(const std::vector<Check>& checks);

}  // namespace cutaway::load
