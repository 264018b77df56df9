#include "net/admission.h"

#include <algorithm>
#include <ranges>
#include <set>
#include <utility>

namespace cutaway {

std::variant<std::unique_ptr<Admission::Ticket>, Admission::Refusal> Admission::enter(
    const ClientAddress& address, Guest guest, TimePoint now) {
  const std::lock_guard lock(mutex_);
  now_ = now;
  const auto is_neighbour = [&](const auto& each) { return each->group == address.group; };
  if (limits_.per_address > 0 && !address.is_exempt &&
      std::ranges::count_if(entries_, is_neighbour) >= limits_.per_address) {
    return Refusal::address_limit;
  }
  turned_away_.forget_the_gone(now);
  if (!finds_place(address.group)) {
    if (limits_.queue == 0 && !address.is_exempt) turned_away_.add(address.group, now);
    return Refusal::full;
  }
  turned_away_.remove(address.group);
  auto entry = std::make_shared<Entry>();
  entry->guest = std::move(guest);
  entry->group = address.group;
  entry->entered = entry->heard = now;
  entries_.push_back(entry);
  settle();
  return std::make_unique<Ticket>(*this, std::move(entry));
}

void Admission::leave(Entry& entry) {
  const std::lock_guard lock(mutex_);
  if (!entry.present) return;
  remove(entry);
  settle();
}

void Admission::heard(Entry& entry, bool page_visible, TimePoint now) {
  const std::lock_guard lock(mutex_);
  entry.heard = now;
  entry.page_visible = page_visible;
}

bool Admission::is_full() const {
  const std::lock_guard lock(mutex_);
  return !has_seat();
}

void Admission::make_room(TimePoint now) {
  const std::lock_guard lock(mutex_);
  now_ = now;
  for (int wanted = waiting(); wanted > 0; --wanted) {
    Entry* idle = idle_seat();
    if (idle == nullptr) break;
    give_way(*idle, Why::idle);
    settle();
  }
  while (is_waited_for()) {
    Entry* beyond = seat_beyond_share();
    if (beyond == nullptr) break;
    give_way(*beyond, Why::over_share);
    settle();
  }
}

// Seats what can be seated, and tells all others where they are now.
void Admission::settle() {
  while (has_seat() && waiting() > 0) seat(*waiting_in_turn().front().entry);
  int place = 0;
  for (const Waiting& each : waiting_in_turn()) tell(*each.entry, ++place);
}

// Who is let in has the whole idle time to say that its page is seen.
void Admission::seat(Entry& entry) {
  entry.seated = true;
  entry.heard = now_;
  ++seated_;
  tell(entry, 0);
}

void Admission::tell(Entry& entry, int place) {
  if (std::exchange(entry.told_place, place) != place) entry.guest.moved(place);
}

void Admission::give_way(Entry& entry, Why why) {
  const auto gives_way = std::move(entry.guest.gives_way);
  remove(entry);
  gives_way(why);
}

void Admission::remove(Entry& entry) {
  entry.present = false;
  seated_ -= entry.seated ? 1 : 0;
  std::erase_if(entries_, [&entry](const auto& each) { return each.get() == &entry; });
}

bool Admission::finds_place(const std::string& newcomer) {
  if (has_seat()) return !is_claimed_by_others(newcomer);
  if (waiting() < limits_.queue) return true;
  return limits_.queue > 0 ? make_room_in_queue(newcomer) : make_room_without_queue(newcomer);
}

// Only for who is there: nobody else could take the seat.
bool Admission::make_room_without_queue(const std::string& newcomer) {
  const auto since = turned_away_.since(newcomer);
  const bool has_waited = since && now_ - *since >= limits_.share_wait;
  Entry* idle = idle_seat();
  Entry* beyond =
      idle == nullptr && has_waited && !has_its_share(newcomer) ? seat_beyond_share() : nullptr;
  if (idle == nullptr && beyond == nullptr) return false;
  give_way(idle ? *idle : *beyond, idle ? Why::idle : Why::over_share);
  return true;
}

// Whether the free seats are for those who were turned away, since the newcomer has its share.
bool Admission::is_claimed_by_others(const std::string& newcomer) const {
  if (turned_away_.all().empty() || !has_its_share(newcomer)) return false;
  const auto claims = std::ranges::count_if(turned_away_.all(), [&](const auto& each) {
    return each.first != newcomer && !has_its_share(each.first);
  });
  return claims >= limits_.seats - seated_;
}

bool Admission::has_its_share(const std::string& group) const {
  const std::map<std::string, int> counts = count(true);
  const auto own = counts.find(group);
  return own != counts.end() && own->second >= share_of(limits_.seats, group);
}

// The last to come, of the address that has most places, makes room for one that has few.
bool Admission::make_room_in_queue(const std::string& newcomer) {
  const std::map<std::string, int> counts = count(false);
  const int share = share_of(limits_.queue, newcomer);
  const auto mine = counts.find(newcomer);
  if (counts.empty() || (mine != counts.end() && mine->second >= share)) return false;
  const auto most =
      std::ranges::max_element(counts, {}, [](const auto& group) { return group.second; });
  if (most->second <= share) return false;
  for (const auto& each : std::views::reverse(entries_)) {
    if (each->seated || each->group != most->first) continue;
    const std::shared_ptr<Entry> leaving = each;  // it is taken off the list
    give_way(*leaving, Why::queue_full);
    return true;
  }
  return false;
}

Admission::Entry* Admission::idle_seat() const {
  Entry* longest = nullptr;
  for (const auto& each : entries_) {
    if (!each->seated || each->page_visible || now_ - each->heard < limits_.idle_seat) continue;
    if (longest == nullptr || each->heard < longest->heard) longest = each.get();
  }
  return longest;
}

// Of the address that has most; a page that is not seen before one that is, then the most silent.
Admission::Entry* Admission::seat_beyond_share() const {
  const std::map<std::string, int> counts = count(true);
  const auto most =
      std::ranges::max_element(counts, {}, [](const auto& group) { return group.second; });
  if (most == counts.end() || most->second <= share_of(limits_.seats, {})) return nullptr;
  Entry* leaving = nullptr;
  for (const auto& each : entries_) {
    if (!each->seated || each->group != most->first) continue;
    const auto rank = [](const Entry& entry) { return std::pair(entry.page_visible, entry.heard); };
    if (leaving == nullptr || rank(*each) < rank(*leaving)) leaving = each.get();
  }
  return leaving;
}

// The first in turn is the one who has the best claim.
bool Admission::is_waited_for() const {
  const auto in_turn = waiting_in_turn();
  return std::ranges::any_of(in_turn, [&](const Waiting& each) {
    return each.beyond_share == 0 && now_ - each.entry->entered >= limits_.share_wait;
  });
}

// First come, first served, among those whose address has less than its share; then the others, by
// how far they would be beyond it.
std::vector<Admission::Waiting> Admission::waiting_in_turn() const {
  std::map<std::string, int> counts = count(true);
  const int share = share_of(limits_.seats, {});
  std::vector<Waiting> in_turn;
  for (const auto& each : entries_) {
    if (each->seated) continue;
    in_turn.push_back({each.get(), std::max(0, ++counts[each->group] - share)});
  }
  std::ranges::stable_sort(in_turn, {}, &Waiting::beyond_share);
  return in_turn;
}

std::map<std::string, int> Admission::count(bool seated) const {
  std::map<std::string, int> counts;
  for (const auto& each : entries_) {
    if (each->seated == seated) ++counts[each->group];
  }
  return counts;
}

int Admission::share_of(int all, const std::string& newcomer) const {
  std::set<std::string> groups;
  for (const auto& each : entries_) groups.insert(each->group);
  for (const auto& [group, wait] : turned_away_.all()) groups.insert(group);
  if (!newcomer.empty()) groups.insert(newcomer);
  return std::max(1, all / std::max(1, static_cast<int>(groups.size())));
}

}  // namespace cutaway
