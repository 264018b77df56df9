// A loop whose turns run side by side.
#pragma once

#include <functional>
#include <stop_token>

namespace cutaway {

/// How many threads a parallel loop uses: the machine's cores.
int default_thread_count();

struct ParallelLoop {
  int count = 0;
  std::function<void(int)> turn;         ///< called once for each of 0..count-1, from any thread
  std::function<void(double)> progress;  ///< fraction 0..1, never falling; from the calling thread
  int threads = default_thread_count();
};

/// Returns when every turn is done. The calling thread works too. What a turn throws is thrown here
/// once the others have ended; Cancelled when `stop` asks for it.
void run_parallel(const ParallelLoop& loop, const std::stop_token& stop);

}  // namespace cutaway
