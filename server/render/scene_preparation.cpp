#include "render/scene_preparation.h"

#include <algorithm>

namespace cutaway {

namespace {

constexpr double kSpeckOfFocus_ml = 0.5;
constexpr double kSpeckOfContext_ml = 2.0;
constexpr double kSpeckShare = 2e-4;  // of what there is to see, where that is less

/// Whose specks are noise.
bool has_specks(DataKind kind) {
  return kind == DataKind::hounsfield || kind == DataKind::mr || kind == DataKind::emission ||
         kind == DataKind::signed_map || kind == DataKind::unknown;
}

std::optional<IslandLimit> limit_of(const ValueBand& band, double smallest_ml) {
  if (!(smallest_ml > 0.0)) return std::nullopt;
  return IslandLimit{band, smallest_ml};
}

std::optional<double> filling(const ValueBand& context, const ValueBand& focus,
                              const ValueRange& range) {
  if (context.has_upper_end() || focus.lower < context.lower) return std::nullopt;
  const double above = std::min(focus.lower - context.lower, 0.4 * (range.maximum - range.minimum));
  return context.lower + 0.5 * above;
}

VolumePreparation preparation_of(const Preparation& wanted, const ValueBand& context,
                                 const ValueBand& focus, const Findings& findings) {
  const bool has_body = findings.body != nullptr;
  VolumePreparation preparation{.hide_couch = wanted.hide_couch && has_body};
  if (wanted.fill_context && has_body)
    preparation.filled_with = filling(context, focus, findings.robust.range);
  preparation.islands = {limit_of(context, wanted.context_islands_ml),
                         limit_of(focus, wanted.focus_islands_ml)};
  return preparation;
}

}  // namespace

Preparation first_preparation(const Findings& findings) {
  Preparation first{.hide_couch = findings.has_couch(), .fill_context = findings.body != nullptr};
  if (!has_specks(findings.kind)) return first;
  const glm::dvec3 extent_mm = findings.shape.extent_mm;
  const double speck_ml = kSpeckShare * extent_mm.x * extent_mm.y * extent_mm.z / 1000.0;
  first.focus_islands_ml = std::min(kSpeckOfFocus_ml, speck_ml);
  first.context_islands_ml = std::min(kSpeckOfContext_ml, speck_ml);
  return first;
}

VolumePreparation preparation_of(const Scene& scene, const LoadedVolume& volume) {
  if (scene.viewport.kind != ViewKind::volume) return {};
  return preparation_of(scene.preparation, scene.context.surface.band, scene.focus.surface.band,
                        volume.findings);
}

VolumePreparation preparation_of_first_look(const LoadedVolume& volume) {
  const Findings& findings = volume.findings;
  return preparation_of(first_preparation(findings), {.lower = findings.outer.value},
                        {.lower = findings.inner.value}, findings);
}

}  // namespace cutaway
