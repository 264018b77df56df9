#include "scene/unseen.h"

#include <cmath>
#include <optional>

#include "scene/json_text.h"
#include "scene/lens_placement.h"

namespace cutaway {

namespace {

std::optional<UnseenReason> reason_for_band(PictureBranch branch, const ValueBand& band,
                                            const VolumeFacts& volume) {
  if (band.lower >= volume.maximum_value)
    return UnseenReason{UnseenCode::above_all_values, branch, band.lower, volume.maximum_value};
  if (band.upper <= volume.minimum_value)
    return UnseenReason{UnseenCode::below_all_values, branch, band.upper, volume.minimum_value};
  if (band.lower >= volume.minimum_value) return std::nullopt;
  return UnseenReason{UnseenCode::fills_the_volume, branch, band.lower, volume.minimum_value};
}

/// Opacity is per millimetre: what is of use in a body leaves a cell transparent.
std::optional<UnseenReason> reason_for_opacity(PictureBranch branch, double opacity_per_mm,
                                               const VolumeFacts& volume) {
  constexpr double kHardlySeen = 0.02;
  const double taken = 1.0 - std::pow(1.0 - opacity_per_mm, volume.diagonal_mm);
  if (taken >= kHardlySeen) return std::nullopt;
  return UnseenReason{UnseenCode::transparent, branch, opacity_per_mm, volume.diagonal_mm};
}

std::optional<UnseenReason> reason_for_branch(PictureBranch name, const Branch& branch,
                                              const VolumeFacts& volume) {
  if (auto reason = reason_for_band(name, branch.surface.band, volume)) return reason;
  return reason_for_opacity(name, branch.surface.opacity, volume);
}

std::optional<UnseenReason> reason_for_lens(const Scene& scene, const VolumeFacts& volume) {
  const LensPlacementView view{scene.camera, scene.viewport, scene.context.surface.band,
                               scene.focus.surface.band, scene.lens.shape};
  switch (sight_of_focus(volume, view, {scene.lens.centre_mm, scene.lens.radius_mm})) {
    case SightOfFocus::some:
      return std::nullopt;
    case SightOfFocus::covered:
      if (scene.lens.opening == LensOpening::funnel) return std::nullopt;
      return UnseenReason{.code = UnseenCode::lens_covered};
    case SightOfFocus::empty:
      return UnseenReason{.code = UnseenCode::lens_empty};
  }
  return std::nullopt;
}

std::string branch_in_words(const UnseenReason& reason) {
  return reason.branch == PictureBranch::focus ? "focus" : "context";
}

}  // namespace

std::vector<UnseenReason> reasons_for_nothing(const Scene& scene, const VolumeFacts& volume) {
  if (scene.viewport.kind != ViewKind::volume) return {};
  if (!(volume.maximum_value > volume.minimum_value))
    return {{.code = UnseenCode::volume_empty, .value = volume.minimum_value}};
  std::vector<UnseenReason> reasons;
  const bool has_lens = scene.lens.mode != LensMode::none && scene.lens.radius_mm > 0.0;
  if (auto reason = reason_for_branch(PictureBranch::context, scene.context, volume))
    reasons.push_back(*reason);
  if (!has_lens) return reasons;
  if (auto reason = reason_for_branch(PictureBranch::focus, scene.focus, volume))
    reasons.push_back(*reason);
  if (!reasons.empty() || scene.lens.mode != LensMode::cutaway) return reasons;
  if (auto reason = reason_for_lens(scene, volume)) reasons.push_back(*reason);
  return reasons;
}

std::string in_words(const UnseenReason& reason) {
  const std::string branch = branch_in_words(reason);
  const std::string nothing = "nothing of the " + branch + " can be seen: ";
  const std::string value = json_text(reason.value.value_or(0.0));
  const std::string limit = json_text(reason.limit.value_or(0.0));
  switch (reason.code) {
    case UnseenCode::volume_empty:
      return "the volume is empty: every voxel has the value " + value;
    case UnseenCode::above_all_values:
      return nothing + "its iso-value, " + value +
             ", is above all values of the volume, which end at " + limit;
    case UnseenCode::below_all_values:
      return nothing + "its upper value, " + value +
             ", is below all values of the volume, which begin at " + limit;
    case UnseenCode::fills_the_volume:
      return "the " + branch + " fills the whole volume: its iso-value, " + value +
             ", is below all values, which begin at " + limit;
    case UnseenCode::transparent:
      return nothing + "an opacity of " + value +
             " per millimetre takes next to no light on the volume's " + limit + " mm";
    case UnseenCode::lens_covered:
      return "the lens shows nothing: it lies inside of the context's material, which covers it";
    case UnseenCode::lens_empty:
      break;
  }
  return "the lens shows nothing: there is nothing of the focus in it";
}

}  // namespace cutaway
