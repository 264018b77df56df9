#pragma once

namespace cutaway::gl {

/// GL errors of the current context become check failures (with the driver's words); the rest goes
/// to the log.
void install_debug_output();

}  // namespace cutaway::gl
