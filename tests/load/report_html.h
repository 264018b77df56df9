// The report as one page: no script, nothing from elsewhere, light and dark.
#pragma once

#include <string>
#include <vector>

#include "load/summary.h"
#include "load/verdict.h"

namespace cutaway::load {

std::string html_report(const Script& script, const Summary& summary,
                        const std::vector<Check>& checks);

}  // namespace cutaway::load
