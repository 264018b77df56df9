// Running out of the device's memory is no bug of ours: whoever wanted the memory is told.
#pragma once

namespace cutaway::gl {

/// Whether the last call found no memory on the device. Asking takes the answer away.
bool ran_out_of_memory();

/// To be called after an allocation. Throws Error "render-failed" naming `what` where the device
/// had no memory for it; a driver tells so much later, or never, if nobody asks.
void throw_if_out_of_memory(const char* what);

/// Throws that error.
[[noreturn]] void throw_out_of_memory(const char* what);

}  // namespace cutaway::gl
