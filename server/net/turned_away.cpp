#include "net/turned_away.h"

namespace cutaway {

namespace {

constexpr std::chrono::seconds kComesBackWithin{40};  // pages do within 15 s
constexpr std::size_t kMost = 1024;

}  // namespace

void TurnedAway::add(const std::string& group, TimePoint now) {
  const auto found = waits_.find(group);
  if (found != waits_.end()) {
    found->second.last = now;
  } else if (waits_.size() < kMost) {
    waits_.emplace(group, Wait{now, now});
  }
}

void TurnedAway::forget_the_gone(TimePoint now) {
  std::erase_if(waits_,
                [now](const auto& each) { return now - each.second.last > kComesBackWithin; });
}

std::optional<TurnedAway::TimePoint> TurnedAway::since(const std::string& group) const {
  const auto found = waits_.find(group);
  return found == waits_.end() ? std::nullopt : std::optional(found->second.since);
}

}  // namespace cutaway
