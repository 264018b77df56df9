#pragma once

#include "core/progress.h"

namespace cutaway {

/// Shows how far a load is on one line of standard error where a person is looking at it; nothing
/// where none is.
ProgressSink terminal_progress();

}  // namespace cutaway
