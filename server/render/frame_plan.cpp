#include "render/frame_plan.h"

#include <algorithm>
#include <limits>

namespace cutaway {

std::int64_t FramePlan::advance(std::int64_t cost) {
  std::int64_t drawn = 0;
  while (!is_done() && drawn < cost) drawn += draw_strip(cost - drawn);
  return drawn;
}

void FramePlan::finish() { advance(std::numeric_limits<std::int64_t>::max()); }

std::int64_t FramePlan::draw_strip(std::int64_t cost) {
  const Pass& pass = passes_[current_];
  const glm::ivec2 size = glm::max(pass.region.end - pass.region.begin, glm::ivec2(0));
  if (next_row_ == 0 && pass.begin) pass.begin();
  const std::int64_t row_cost = std::max<std::int64_t>(1, std::int64_t{pass.cost} * size.x);
  const auto rows = static_cast<int>(
      std::clamp<std::int64_t>(cost / row_cost, 1, std::max(1, size.y - next_row_)));
  if (!pass.region.is_empty()) {
    const int first = pass.region.begin.y + next_row_;
    pass.draw({{pass.region.begin.x, first}, {pass.region.end.x, first + rows}});
  }
  next_row_ += rows;
  if (next_row_ >= size.y) {
    if (pass.done) pass.done();
    if (observer_) observer_(pass.name);
    next_row_ = 0;
    ++current_;
  }
  return rows * row_cost;
}

}  // namespace cutaway
