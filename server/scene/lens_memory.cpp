#include "scene/lens_memory.h"

#include <utility>

#include "scene/volume_choices.h"

namespace cutaway {

PlacedLens LensMemory::lens(const VolumeFacts& volume, const LensPlacementView& view,
                            std::optional<double> radius_mm) {
  Question question{volume.id, view, radius_mm};
  if (question_ == question) return answer_;
  ++searches_;
  answer_ = chosen_lens(volume, view, radius_mm);
  question_ = std::move(question);
  return answer_;
}

int LensMemory::take_searches() { return std::exchange(searches_, 0); }

}  // namespace cutaway
