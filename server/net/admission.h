// Who may have a session, and in which order the others wait for one.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "net/client_address.h"
#include "net/turned_away.h"

namespace cutaway {

/// A limited number of seats and, when all are taken, a limited queue for them. One address may
/// have all of them while nobody else wants one. Its share (all of them divided by the addresses
/// that have or want one) binds while others wait: what it wants beyond comes after them, and what
/// it has beyond, it gives up to them. Thread-safe; outlives its tickets.
class Admission {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Limits {
    int seats = 1;
    int queue = 0;
    int per_address = 0;  ///< seats and places in the queue of one address; 0: all
    std::chrono::milliseconds idle_seat{30'000};
    std::chrono::milliseconds share_wait{20'000};
  };

  enum class Why {
    idle,        ///< a seat: its page was not seen and nothing came from it
    over_share,  ///< a seat: its address has more than its share, and another waits
    queue_full   ///< a place in the queue: likewise, and there is none left
  };
  enum class Refusal { full, address_limit };

  /// Called from any thread, one call at a time; must not come back to the admission.
  struct Guest {
    std::function<void(int place)> moved;    ///< 1 for the next in the queue, 0 for a seat
    std::function<void(Why why)> gives_way;  ///< it has neither any more, and hears no more
  };

  /// Being seated or in the queue; destroying it leaves.
  class Ticket;

  explicit Admission(const Limits& limits) : limits_(limits) {}

  /// `moved` hears of the first place, too, before this returns.
  std::variant<std::unique_ptr<Ticket>, Refusal> enter(const ClientAddress& address, Guest guest,
                                                       TimePoint now);

  /// While someone waits, has seats given up: those of pages that are hidden, or never said that
  /// they are seen, and were silent for the idle time; and, for who has waited for `share_wait`
  /// within its address' share, the most silent one of the address that is furthest beyond its own.
  /// To be called now and then.
  void make_room(TimePoint now);

  bool is_full() const;

 private:
  struct Entry {
    Guest guest;
    std::string group;
    TimePoint entered;
    TimePoint heard;
    int told_place = -1;
    bool seated = false;
    bool page_visible = false;
    bool present = true;
  };
  using Entries = std::list<std::shared_ptr<Entry>>;
  struct Waiting {
    Entry* entry;
    int beyond_share;
  };

  void leave(Entry& entry);
  void heard(Entry& entry, bool page_visible, TimePoint now);
  void settle();
  void seat(Entry& entry);
  void tell(Entry& entry, int place);
  void give_way(Entry& entry, Why why);
  void remove(Entry& entry);
  bool finds_place(const std::string& newcomer);
  bool make_room_in_queue(const std::string& newcomer);
  bool make_room_without_queue(const std::string& newcomer);
  bool is_claimed_by_others(const std::string& newcomer) const;
  bool has_its_share(const std::string& group) const;
  Entry* idle_seat() const;
  Entry* seat_beyond_share() const;
  std::vector<Waiting> waiting_in_turn() const;
  std::map<std::string, int> count(bool seated) const;
  int share_of(int all, const std::string& newcomer) const;
  bool is_waited_for() const;
  bool has_seat() const { return seated_ < limits_.seats; }
  int waiting() const { return static_cast<int>(entries_.size()) - seated_; }

  mutable std::mutex mutex_;
  Limits limits_;
  TimePoint now_;  ///< when the admission was last told the time
  int seated_ = 0;
  Entries entries_;  ///< in the order in which they came
  TurnedAway turned_away_;
};

class Admission::Ticket {
 public:
  Ticket(Admission& admission, std::shared_ptr<Entry> entry)
      : admission_(admission), entry_(std::move(entry)) {}
  ~Ticket() { admission_.leave(*entry_); }
  Ticket(const Ticket&) = delete;
  Ticket& operator=(const Ticket&) = delete;

  /// Something came from this client, whose page is seen or not.
  void heard(bool page_visible, TimePoint now) { admission_.heard(*entry_, page_visible, now); }

 private:
  Admission& admission_;
  std::shared_ptr<Entry> entry_;
};

}  // namespace cutaway
