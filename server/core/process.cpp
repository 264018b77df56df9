#include "core/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <initializer_list>

namespace cutaway {

void keep_standard_streams() {
  signal(SIGPIPE, SIG_IGN);
  int opened = 0;
  // Each open takes the lowest number that is free.
  while (opened >= 0 && opened <= STDERR_FILENO) opened = open("/dev/null", O_RDWR);
  if (opened >= 0) close(opened);
}

void survive_stray_signals() {
  for (const int stray : {SIGHUP, SIGUSR1, SIGUSR2}) signal(stray, SIG_IGN);
}

void forbid_core_dumps() {
  rlimit limit{};
  getrlimit(RLIMIT_CORE, &limit);
  limit.rlim_cur = 0;
  setrlimit(RLIMIT_CORE, &limit);
  prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
}

}  // namespace cutaway
