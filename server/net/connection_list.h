// The connections that are open: to count them, to end them, and to choose who gives way when all
// are taken.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "net/client_address.h"

namespace cutaway {

/// What the list can do to a connection; from any thread.
class OpenConnection {
 public:
  virtual ~OpenConnection() = default;
  /// Ends it: a session with a closing handshake, all else at once.
  virtual void close() = 0;
  /// Ends it at once.
  virtual void abort() = 0;
};

/// Thread-safe; outlives its places. Holds connections weakly.
class ConnectionList {
 public:
  /// In the order in which they give way.
  enum class Use { awaits_request, answers, session };

  /// A connection's place in the list; destroying it leaves.
  class Place;

  /// `per_address` 0: as many as there are.
  ConnectionList(int most, int per_address) : most_(most), per_address_(per_address) {}

  /// When all places are taken, a connection that waits for a request (or the rest of one) gives
  /// its place up. It is one of the address with the most connections, and of those the one that
  /// has waited longest. When none waits, an address with more than its share gives one up to a
  /// newcomer whose address has less. Null when nobody gives way, or when the newcomer's address
  /// has all that it may have.
  std::unique_ptr<Place> add(std::weak_ptr<OpenConnection> connection,
                             const ClientAddress& address);

  std::size_t size() const;
  void for_each(const std::function<void(OpenConnection&)>& visit) const;

 private:
  struct Entry {
    std::weak_ptr<OpenConnection> connection;
    std::string group;
    Use use = Use::awaits_request;
    std::uint64_t since = 0;  ///< of this use; counts up
    bool leaves = false;      ///< was told to
  };
  using Entries = std::list<Entry>;

  void remove(Entries::iterator entry);
  bool regroup(Entries::iterator entry, const ClientAddress& address);
  void set_use(Entries::iterator entry, Use use);
  bool may_have_one_more(const ClientAddress& address) const;
  Entry* who_gives_way(const std::string& newcomer);
  int count_of(const std::string& group) const;
  void forget(const Entry& entry);

  mutable std::mutex mutex_;
  int most_;
  int per_address_;
  Entries entries_;
  std::map<std::string, int> counts_;  ///< by group, without those who leave
  int staying_ = 0;
  std::uint64_t clock_ = 0;
};

class ConnectionList::Place {
 public:
  Place(ConnectionList& list, Entries::iterator entry) : list_(list), entry_(entry) {}
  ~Place() { list_.remove(entry_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// It turns out to be another client's, behind a proxy. False where that one has all it may have.
  [[nodiscard]] bool belongs_to(const ClientAddress& address) {
    return list_.regroup(entry_, address);
  }
  void is_used_as(Use use) { list_.set_use(entry_, use); }

 private:
  ConnectionList& list_;
  Entries::iterator entry_;
};

}  // namespace cutaway
