// Threads, and what is said where the system gives no more of them.
#pragma once

#include <functional>
#include <stop_token>
#include <thread>

namespace cutaway {

/// As std::jthread makes it, but throws Error that says what the limit is. What `work` throws ends
/// the process.
std::jthread start_thread(std::function<void(const std::stop_token&)> work);

/// Returns where so many more threads can be had at this moment, else throws Error. For what starts
/// threads of its own and does not bear to get none: Mesa's software renderer waits for ever for
/// the work of a thread that could not be started.
void require_threads(int count);

}  // namespace cutaway
