#include "services/first_volume.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace cutaway {

namespace {

double worth_of_modality(const std::string& modality) {
  if (modality == "CT") return 1.0;
  if (modality == "MR") return 0.9;
  return modality.empty() ? 0.7 : 0.6;
}

bool names_a_mask(std::string name) {
  constexpr std::array<std::string_view, 4> kWords{"label", "mask", "seg.", "_seg"};
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// 1 from `enough` on.
double share_of(double value, double enough) { return std::min(value / enough, 1.0); }

}  // namespace

double worth_seeing(const VolumeDescription& description, const VolumeGeometry& geometry) {
  const glm::dvec3 size(geometry.size_voxels);
  const glm::dvec3 spacing = geometry.spacing_mm;
  const double thinnest = std::min({size.x, size.y, size.z});
  const double cubic =
      std::min({spacing.x, spacing.y, spacing.z}) / std::max({spacing.x, spacing.y, spacing.z});
  const double grid =
      share_of(thinnest, 96.0) * share_of(std::cbrt(size.x * size.y * size.z), 256.0);
  const double named = names_a_mask(description.id) ? 0.1 : 1.0;
  return grid * std::sqrt(cubic) * worth_of_modality(description.modality) * named;
}

}  // namespace cutaway
