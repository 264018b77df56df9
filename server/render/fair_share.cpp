#include "render/fair_share.h"

#include <algorithm>

namespace cutaway {

std::uint64_t FairShare::next(std::span<const std::uint64_t> waiting) {
  for (const std::uint64_t view : waiting) {
    std::int64_t& used = used_[view];
    used = std::max(used, least_);
  }
  const std::uint64_t view =
      *std::ranges::min_element(waiting, {}, [this](std::uint64_t each) { return used_[each]; });
  least_ = used_[view];
  return view;
}

}  // namespace cutaway
