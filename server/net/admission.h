// Who may have a session, and in which order the others wait for one.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

namespace cutaway {

/// A limited number of seats and, when all are taken, a limited queue for them, first come first
/// served. Thread-safe; outlives its tickets.
class Admission {
 public:
  /// Told of each new place: 1 for the next in the queue, 0 for a seat. Called from any thread, one
  /// call at a time, and must not come back to the admission.
  using Moved = std::function<void(int place)>;

  Admission(int seats, int queue) : seats_(seats), queue_(queue) {}

  /// Being seated or in the queue; destroying it leaves.
  class Ticket;

  /// Null where the queue is full, too. `moved` hears of the first place, too, before this returns.
  std::unique_ptr<Ticket> enter(Moved moved);

 private:
  struct Guest {
    Moved moved;
    bool seated = false;
  };
  using Place = std::list<Guest>::iterator;

  void leave(Place place);
  bool has_seat() const { return seated_ < seats_; }

  std::mutex mutex_;
  int seats_;
  int queue_;
  int seated_ = 0;
  std::list<Guest> guests_;  ///< those who wait, in their order; the seated ones are before them
};

class Admission::Ticket {
 public:
  Ticket(Admission& admission, Place place) : admission_(admission), place_(place) {}
  ~Ticket() { admission_.leave(place_); }
  Ticket(const Ticket&) = delete;
  Ticket& operator=(const Ticket&) = delete;

 private:
  Admission& admission_;
  Place place_;
};

}  // namespace cutaway
