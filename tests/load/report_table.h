// The report for a terminal.
#pragma once

#include <ostream>
#include <vector>

#include "load/summary.h"
#include "load/verdict.h"

namespace cutaway::load {

/// Every client where they are few, else those with the lowest frame rates and those in trouble.
void print_table(std::ostream& out, const Script& script, const Summary& summary,
                 const std::vector<Check>& checks);

}  // namespace cutaway::load
