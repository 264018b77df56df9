#include "render/filters/flow.h"

#include <cmath>

namespace cutaway {

int blur_reach_px(double sigma_px) { return static_cast<int>(std::ceil(2.5 * sigma_px)); }

FilterStep blur_step(int shader, const WorkTexture& from, const WorkTexture& to, glm::ivec2 along,
                     double sigma_px) {
  const int reach_px = blur_reach_px(sigma_px);
  return {.shader = shader,
          .writes = {to},
          .reads = {{"unblurred", from}},
          .reach_px = reach_px,
          .along = along,
          .numbers = {{"sigma_px", static_cast<float>(sigma_px)}},
          .cost = 1 + reach_px / 2};
}

}  // namespace cutaway
