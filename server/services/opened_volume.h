// A loaded volume as sessions see it.
#pragma once

#include <memory>
#include <string>

#include "services/prepared_volumes.h"
#include "session/volume_library.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Immutable, but for what is kept of its preparations.
class OpenedVolume final : public OpenVolume {
 public:
  explicit OpenedVolume(const std::shared_ptr<const LoadedVolume>& loaded);
  /// `first_seen`: what preparation_of_first_look makes of it; the volume itself where that is
  /// nothing.
  OpenedVolume(std::shared_ptr<const LoadedVolume> loaded,
               std::shared_ptr<const LoadedVolume> first_seen);

  const VolumeFacts& facts() const override { return facts_; }
  const std::string& units() const override { return loaded_->volume.description.units; }
  const Json& summary() const override { return summary_; }
  std::optional<double> value_at(glm::dvec3 position_mm) const override;
  std::optional<double> value_to_the_faces(glm::dvec3 position_mm) const override;

  SurfaceProbe probe(const Scene& scene) const override;

  const std::shared_ptr<const LoadedVolume>& loaded() const { return loaded_; }
  PreparedVolumes& prepared() const { return prepared_; }
  /// As the scene has it prepared, or as near to it as has been made.
  std::shared_ptr<const LoadedVolume> seen_in(const Scene& scene) const;

 private:
  /// `beyond`: the outermost centres, voxels.
  std::optional<double> value_within(glm::dvec3 position_mm, double beyond) const;

  std::shared_ptr<const LoadedVolume> loaded_;
  mutable PreparedVolumes prepared_;  ///< a cache: what is seen of the volume does not change
  glm::dmat4 patient_to_index_;
  VolumeFacts facts_;
  Json summary_;
};

}  // namespace cutaway
