#include "net/connection_list.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace cutaway {

std::unique_ptr<ConnectionList::Place> ConnectionList::add(std::weak_ptr<OpenConnection> connection,
                                                           const ClientAddress& address) {
  std::shared_ptr<OpenConnection> last_hold;  // let go after the lock: its end may come back here
  const std::lock_guard lock(mutex_);
  if (!may_have_one_more(address)) return nullptr;
  if (staying_ >= most_) {
    Entry* leaving = who_gives_way(address.group);
    if (leaving == nullptr) return nullptr;
    forget(*leaving);
    leaving->leaves = true;
    last_hold = leaving->connection.lock();
    if (last_hold) last_hold->abort();
  }
  ++staying_;
  ++counts_[address.group];
  return std::make_unique<Place>(
      *this, entries_.insert(
                 entries_.end(),
                 {.connection = std::move(connection), .group = address.group, .since = ++clock_}));
}

void ConnectionList::remove(Entries::iterator entry) {
  const std::lock_guard lock(mutex_);
  if (!entry->leaves) forget(*entry);
  entries_.erase(entry);
}

bool ConnectionList::regroup(Entries::iterator entry, const ClientAddress& address) {
  const std::lock_guard lock(mutex_);
  if (entry->leaves || entry->group == address.group) return true;
  if (!may_have_one_more(address)) return false;
  forget(*entry);
  ++staying_;
  ++counts_[address.group];
  entry->group = address.group;
  return true;
}

void ConnectionList::set_use(Entries::iterator entry, Use use) {
  const std::lock_guard lock(mutex_);
  entry->use = use;
  entry->since = ++clock_;
}

bool ConnectionList::may_have_one_more(const ClientAddress& address) const {
  return per_address_ == 0 || address.is_exempt || count_of(address.group) < per_address_;
}

int ConnectionList::count_of(const std::string& group) const {
  const auto found = counts_.find(group);
  return found == counts_.end() ? 0 : found->second;
}

void ConnectionList::forget(const Entry& entry) {
  --staying_;
  const auto count = counts_.find(entry.group);
  if (--count->second == 0) counts_.erase(count);
}

// Among those of one use, the greediest address first, then whoever has been at it longest.
ConnectionList::Entry* ConnectionList::who_gives_way(const std::string& newcomer) {
  const int groups = static_cast<int>(counts_.size()) + (count_of(newcomer) == 0 ? 1 : 0);
  const int share = std::max(1, most_ / groups);
  const bool has_claim = count_of(newcomer) < share;
  Entry* best = nullptr;
  const auto rank = [this](const Entry& entry) {
    return std::tuple(entry.use, -count_of(entry.group), entry.since);
  };
  for (Entry& entry : entries_) {
    const bool gives_way =
        entry.use == Use::awaits_request || (has_claim && count_of(entry.group) > share);
    if (entry.leaves || !gives_way) continue;
    if (best == nullptr || rank(entry) < rank(*best)) best = &entry;
  }
  return best;
}

std::size_t ConnectionList::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void ConnectionList::for_each(const std::function<void(OpenConnection&)>& visit) const {
  std::vector<std::shared_ptr<OpenConnection>> open;
  {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
      if (auto connection = entry.connection.lock()) open.push_back(std::move(connection));
    }
  }
  for (const auto& connection : open) visit(*connection);
}

}  // namespace cutaway
