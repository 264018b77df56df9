// What a process settles with the system when it starts, before it has a second thread.
#pragma once

namespace cutaway {

/// A reader that goes away is an error of writing and not the end of the process (SIGPIPE is
/// ignored); a standard descriptor that is closed becomes /dev/null, so that no file or connection
/// gets its number and what is meant for a person.
void keep_standard_streams();

/// Whoever serves outlives the terminal that it was started from (SIGHUP), and what is sent by
/// mistake (SIGUSR1, SIGUSR2).
void survive_stray_signals();

/// Nothing in this process' memory, patients' images least of all, is written to a disk or handed
/// to a collector when it breaks down; nor may other processes of the user read it. The limit of
/// core files alone would not do: the kernel does not ask it where cores are piped to a program.
/// Children that are other programs start without this.
void forbid_core_dumps();

}  // namespace cutaway
