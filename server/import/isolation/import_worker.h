// The other side of isolated_reader.h: the process that reads one file and says what it found.
#pragma once

namespace cutaway {

/// The body of a hidden subcommand: takes one job from standard input, answers on descriptors 3 and
/// 4 (worker_protocol.h), returns the exit status. Nothing else of the process may use those
/// descriptors.
int run_import_worker();

}  // namespace cutaway
