#include "scene/unseen.h"

#include <cmath>
#include <optional>

#include "scene/json_text.h"
#include "scene/lens_placement.h"

namespace cutaway {

namespace {

std::optional<std::string> reason_for_band(const std::string& branch, const ValueBand& band,
                                           const VolumeFacts& volume) {
  const std::string nothing = "nothing of the " + branch + " can be seen: ";
  if (band.lower >= volume.maximum_value) {
    return nothing + "its iso-value, " + json_text(band.lower) +
           ", is above all values of the volume, which end at " + json_text(volume.maximum_value);
  }
  if (band.upper <= volume.minimum_value) {
    return nothing + "its upper value, " + json_text(band.upper) +
           ", is below all values of the volume, which begin at " + json_text(volume.minimum_value);
  }
  if (band.lower >= volume.minimum_value) return std::nullopt;
  return "the " + branch + " fills the whole volume: its iso-value, " + json_text(band.lower) +
         ", is below all values, which begin at " + json_text(volume.minimum_value);
}

/// Opacity is per millimetre: what is of use in a body leaves a cell transparent.
std::optional<std::string> reason_for_opacity(const std::string& branch, double opacity_per_mm,
                                              const VolumeFacts& volume) {
  constexpr double kHardlySeen = 0.02;
  const double taken = 1.0 - std::pow(1.0 - opacity_per_mm, volume.diagonal_mm);
  if (taken >= kHardlySeen) return std::nullopt;
  return "nothing of the " + branch + " can be seen: an opacity of " + json_text(opacity_per_mm) +
         " per millimetre takes next to no light on the volume's " + json_text(volume.diagonal_mm) +
         " mm";
}

std::optional<std::string> reason_for_branch(const std::string& name, const Branch& branch,
                                             const VolumeFacts& volume) {
  if (auto reason = reason_for_band(name, branch.surface.band, volume)) return reason;
  return reason_for_opacity(name, branch.surface.opacity, volume);
}

std::optional<std::string> reason_for_lens(const Scene& scene, const VolumeFacts& volume) {
  const LensPlacementView view{scene.camera, scene.viewport, scene.context.surface.band,
                               scene.focus.surface.band, scene.lens.shape};
  switch (sight_of_focus(volume, view, {scene.lens.centre_mm, scene.lens.radius_mm})) {
    case SightOfFocus::some:
      return std::nullopt;
    case SightOfFocus::covered:
      return "the lens shows nothing: it lies inside of the context's material, which covers it";
    case SightOfFocus::empty:
      return "the lens shows nothing: there is nothing of the focus in it";
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> reasons_for_nothing(const Scene& scene, const VolumeFacts& volume) {
  if (scene.viewport.kind != ViewKind::volume) return {};
  if (!(volume.maximum_value > volume.minimum_value))
    return {"the volume is empty: every voxel has the value " + json_text(volume.minimum_value)};
  std::vector<std::string> reasons;
  const bool has_lens = scene.lens.mode != LensMode::none && scene.lens.radius_mm > 0.0;
  if (auto reason = reason_for_branch("context", scene.context, volume))
    reasons.push_back(*std::move(reason));
  if (!has_lens) return reasons;
  if (auto reason = reason_for_branch("focus", scene.focus, volume))
    reasons.push_back(*std::move(reason));
  if (!reasons.empty() || scene.lens.mode != LensMode::cutaway) return reasons;
  if (auto reason = reason_for_lens(scene, volume)) reasons.push_back(*std::move(reason));
  return reasons;
}

}  // namespace cutaway
