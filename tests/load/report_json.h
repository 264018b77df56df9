// The report for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "load/summary.h"
#include "load/verdict.h"

namespace cutaway::load {

/// Names end in their unit.
nlohmann::json json_report(const Script& script, const Summary& summary,
                           const std::vector<Check>& checks);

}  // namespace cutaway::load
