#include "render/filters/image_filter.h"

#include <ranges>

namespace cutaway {

FilterPlan chained(std::vector<FilterStep> steps) {
  int reach_px = 0;
  for (FilterStep& step : std::views::reverse(steps)) {
    step.before_px = step.further_px = glm::ivec2(reach_px);
    reach_px += step.reach_px;
  }
  return {std::move(steps), reach_px};
}

FilterPlan single_step(const Json& /*parameters*/, double /*resolution_scale*/) {
  return chained({{.shader = 0, .reach_px = 1}});
}

}  // namespace cutaway
