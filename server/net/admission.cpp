#include "net/admission.h"

#include <utility>

namespace cutaway {

std::unique_ptr<Admission::Ticket> Admission::enter(Moved moved) {
  const std::lock_guard lock(mutex_);
  const int waiting = static_cast<int>(guests_.size()) - seated_;
  if (!has_seat() && waiting >= queue_) return nullptr;
  const Place place = guests_.insert(guests_.end(), {std::move(moved), has_seat()});
  seated_ += place->seated ? 1 : 0;
  place->moved(place->seated ? 0 : waiting + 1);
  return std::make_unique<Ticket>(*this, place);
}

// Everyone behind the one who leaves moves up.
void Admission::leave(Place left) {
  const std::lock_guard lock(mutex_);
  const bool frees_seat = left->seated;
  bool is_behind = frees_seat;
  const Place next = guests_.erase(left);
  if (frees_seat) --seated_;
  int place = 0;
  for (Place guest = guests_.begin(); guest != guests_.end(); ++guest) {
    is_behind = is_behind || guest == next;
    if (guest->seated) continue;
    if (has_seat()) {
      guest->seated = true;
      ++seated_;
      guest->moved(0);
    } else {
      ++place;
      if (is_behind) guest->moved(place);
    }
  }
}

}  // namespace cutaway
