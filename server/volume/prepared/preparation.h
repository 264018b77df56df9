// A volume made ready to be drawn: without what is no patient, without holes, without specks.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/value_band.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Parts of a band's material that are smaller are left out of it.
struct IslandLimit {
  ValueBand band;
  double smallest_ml = 0.0;
  bool operator==(const IslandLimit&) const = default;
};

/// In the order in which it is done.
struct VolumePreparation {
  bool hide_couch = false;
  std::optional<double> filled_with;  ///< physical: what the body encloses has at least this value
  std::array<std::optional<IslandLimit>, 2> islands = {};
  bool operator==(const VolumePreparation&) const = default;

  bool is_nothing() const { return *this == VolumePreparation{}; }
};

/// A copy of the volume with the preparation done, and what is derived from it; its findings are
/// the measured one's. Where no body was found, couch and filling stay as they are. Seconds for a
/// large volume. Throws Cancelled.
std::shared_ptr<const LoadedVolume> prepare(const LoadedVolume& measured,
                                            const VolumePreparation& preparation,
                                            const std::stop_token& stop);

}  // namespace cutaway
