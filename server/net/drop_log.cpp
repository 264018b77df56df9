#include "net/drop_log.h"

#include <utility>

#include "core/log.h"

namespace cutaway {

void DropLog::note(const std::string& what, const std::string& peer) {
  const std::lock_guard lock(mutex_);
  Happened& happened = happened_[what];
  ++happened.times;
  happened.last_peer = peer;
}

void DropLog::flush() {
  std::map<std::string, Happened> happened;
  {
    const std::lock_guard lock(mutex_);
    happened = std::exchange(happened_, {});
  }
  for (const auto& [what, each] : happened) {
    log().warn("{}: {} in a second, {} the last", what, each.times, each.last_peer);
  }
}

}  // namespace cutaway
