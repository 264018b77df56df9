// The connections that are open, to count them and to end them.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>

namespace cutaway {

/// Thread-safe. Holds connections weakly; an entry lives as long as its handle.
template <typename Connection>
class ConnectionList {
 public:
  using Entries = std::list<std::weak_ptr<Connection>>;

  typename Entries::iterator add(const std::shared_ptr<Connection>& connection) {
    const std::lock_guard lock(mutex_);
    return entries_.insert(entries_.end(), connection);
  }

  void remove(typename Entries::iterator entry) {
    const std::lock_guard lock(mutex_);
    entries_.erase(entry);
  }

  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return entries_.size();
  }

  void for_each(const std::function<void(const std::shared_ptr<Connection>&)>& visit) const {
    for (const auto& connection : open_ones()) visit(connection);
  }

 private:
  std::list<std::shared_ptr<Connection>> open_ones() const {
    const std::lock_guard lock(mutex_);
    std::list<std::shared_ptr<Connection>> connections;
    for (const auto& entry : entries_) {
      if (auto connection = entry.lock()) connections.push_back(std::move(connection));
    }
    return connections;
  }

  mutable std::mutex mutex_;
  Entries entries_;
};

}  // namespace cutaway
