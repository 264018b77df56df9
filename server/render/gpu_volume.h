// A volume on the device, with what rays need to skip its empty parts.
#pragma once

#include <list>
#include <memory>

#include "gl/program.h"
#include "gl/texture.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Render thread only. Holds the loaded volume alive.
class GpuVolume {
 public:
  /// Uploads slab by slab. Throws Error "volume-refused" when the device cannot hold so large a
  /// texture.
  GpuVolume(std::shared_ptr<const LoadedVolume> loaded, int max_texture_size,
            const ProgressSink& progress);

  const Volume& volume() const { return loaded_->volume; }
  const LoadedVolume* identity() const { return loaded_.get(); }

  /// A physical value as the shaders' samples have it.
  float to_stored(double physical_value) const;

  /// Uniforms of shaders/volume.glsl; the texture goes to `unit`.
  void set_uniforms(const gl::Program& program, int unit) const;

  /// Uniforms of shaders/empty_space.glsl for the bands of context and focus; the maps go to `unit`
  /// and `unit` + 1. A map is computed at its first use and kept while it is among the most
  /// recently used.
  void set_empty_space(const gl::Program& program, int unit, const ValueBand& context,
                       const ValueBand& focus);

 private:
  struct DistanceMap {
    ValueBand band;
    gl::Texture3D texture;
  };
  GLuint distance_map(const ValueBand& band);

  std::shared_ptr<const LoadedVolume> loaded_;
  gl::Texture3D texture_;
  double stored_scale_ = 1.0;             ///< texture units per stored number
  std::list<DistanceMap> distance_maps_;  ///< most recently used first
};

}  // namespace cutaway
