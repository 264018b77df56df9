// How a run goes, on standard error.
#pragma once

#include "load/run.h"

namespace cutaway::load {

/// One line a second, rewritten in place on a terminal; elsewhere one line every ten seconds.
Progress progress_line(int clients, double seconds);

}  // namespace cutaway::load
