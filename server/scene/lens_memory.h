// The lens that was chosen last, so that the same question is not looked into twice.
#pragma once

#include <optional>
#include <string>

#include "scene/lens_placement.h"

namespace cutaway {

/// Looking for a lens' place takes tens of milliseconds. Not thread-safe: each session has its own.
class LensMemory {
 public:
  /// As chosen_lens; looks only where the question is another one than the last. A volume's id
  /// stands for its content.
  PlacedLens lens(const VolumeFacts& volume, const LensPlacementView& view,
                  std::optional<double> radius_mm);

  /// How often it has looked since this was asked last.
  int take_searches();

 private:
  struct Question {
    std::string volume;
    LensPlacementView view;
    std::optional<double> radius_mm;
    bool operator==(const Question&) const = default;
  };

  std::optional<Question> question_;
  PlacedLens answer_;
  int searches_ = 0;
};

}  // namespace cutaway
