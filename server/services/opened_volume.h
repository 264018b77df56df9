// A loaded volume as sessions see it.
#pragma once

#include <memory>
#include <string>

#include "session/volume_library.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Immutable.
class OpenedVolume final : public OpenVolume {
 public:
  explicit OpenedVolume(std::shared_ptr<const LoadedVolume> loaded);

  const VolumeFacts& facts() const override { return facts_; }
  const std::string& units() const override { return loaded_->volume.description.units; }
  const Json& summary() const override { return summary_; }
  std::optional<double> value_at(glm::dvec3 position_mm) const override;
  std::optional<double> value_to_the_faces(glm::dvec3 position_mm) const override;

  const std::shared_ptr<const LoadedVolume>& loaded() const { return loaded_; }

 private:
  /// `beyond`: the outermost centres, voxels.
  std::optional<double> value_within(glm::dvec3 position_mm, double beyond) const;

  std::shared_ptr<const LoadedVolume> loaded_;
  glm::dmat4 patient_to_index_;
  VolumeFacts facts_;
  Json summary_;
};

}  // namespace cutaway
