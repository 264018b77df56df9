#include "render/view_turns.h"

#include <vector>

namespace cutaway {

std::uint64_t ViewTurns::next(std::span<const ShareOfView> waiting) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(waiting.size());
  for (const ShareOfView& each : waiting) numbers.push_back(each.share);
  const std::uint64_t share = shares_.next(numbers);
  numbers.clear();
  for (const ShareOfView& each : waiting) {
    if (each.share == share) numbers.push_back(each.view);
  }
  return views_[share].next(numbers);
}

void ViewTurns::charge(const ShareOfView& who, std::int64_t cost) {
  shares_.charge(who.share, cost);
  views_[who.share].charge(who.view, cost);
}

void ViewTurns::forget(std::uint64_t view) {
  for (auto at = views_.begin(); at != views_.end();) {
    at->second.forget(view);
    if (at->second.knows_nobody()) {
      shares_.forget(at->first);
      at = views_.erase(at);
    } else {
      ++at;
    }
  }
}

}  // namespace cutaway
