// A volume on the device, with what rays need to skip its empty parts.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gl/program.h"
#include "gl/texture.h"
#include "render/empty_space.h"
#include "render/tissue_ramp.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Tells volumes apart, also from one that is gone: another may lie at its address by then.
struct VolumeIdentity {
  std::weak_ptr<const LoadedVolume> volume;
  bool operator==(const VolumeIdentity& other) const {
    return !volume.owner_before(other.volume) && !other.volume.owner_before(volume);
  }
};

/// Render thread only. Holds the loaded volume alive.
class GpuVolume {
 public:
  /// Makes room on the device. Throws Error "volume-refused" or "too-large" when it cannot hold so
  /// large a texture.
  GpuVolume(std::shared_ptr<const LoadedVolume> loaded, int max_texture_size);

  /// Uploads the next few megabytes. Throws Error "too-large" when the device's memory is at its
  /// end.
  void upload_slab();
  void upload_rest();
  double uploaded() const;  ///< fraction, 0..1
  /// Until then nothing can be drawn from it.
  bool is_complete() const { return uploading_ == levels_.size(); }

  const Volume& volume() const { return loaded_->volume; }
  VolumeIdentity identity() const { return {loaded_}; }
  /// Whether anyone but this holds the loaded volume.
  bool is_wanted() const { return loaded_.use_count() > 1; }
  /// What the textures of a volume take on the device.
  static std::uint64_t texture_bytes(const LoadedVolume& loaded);
  std::uint64_t texture_bytes() const { return texture_bytes(*loaded_); }

  /// A physical value as the shaders' samples have it.
  float to_stored(double physical_value) const;
  /// Lower and upper limit; where there is no upper one, above every stored value (NO_UPPER_LIMIT
  /// of shaders/bands.glsl).
  glm::vec2 to_stored(const ValueBand& band) const;

  const TissueRamp& tissues() const { return tissues_; }

  /// Uniforms of shaders/volume.glsl; the texture goes to `unit`.
  void set_uniforms(const gl::Program& program, int unit) const;

  /// The coarser copies; see LoadedVolume::pyramid.
  std::size_t coarse_levels() const { return levels_.size() - 1; }
  /// Uniforms of shaders/coarse_volume.glsl for the level `number`, 0 for the volume itself; the
  /// texture goes to `unit`.
  void set_level(const gl::Program& program, int unit, std::size_t number) const;
  /// Voxels that a texel of each level spans, from the volume's own on.
  std::vector<glm::ivec3> level_factors() const;

  /// For the bands of context and focus; see EmptySpace.
  const EmptySpaceMaps& empty_space(const ValueBand& context, const ValueBand& focus) {
    return empty_space_.maps(loaded_->min_max, volume().geometry.size_voxels, context, focus);
  }
  /// The part of the volume that holds something of these bands, to a brick; all of it where none
  /// does.
  VolumeGeometry occupied_part(const ValueBand& context, const ValueBand& focus) {
    const VoxelBox& box = empty_space(context, focus).occupied;
    return part_of(volume().geometry, box.first, box.last);
  }
  /// Uniforms of shaders/empty_space.glsl; the distances go to `unit`.
  void set_empty_space(const gl::Program& program, int unit, const EmptySpaceMaps& maps) const;

 private:
  std::shared_ptr<const LoadedVolume> loaded_;
  /// The volume, then its coarser copies.
  struct Level {
    const Voxels* voxels;  ///< of `loaded_`
    glm::ivec3 factor;
    gl::Texture3D texture;
  };
  std::size_t upload_slices(std::size_t most_bytes);  ///< returns how many it took
  void add_level(const Voxels& voxels, glm::ivec3 factor, glm::ivec3 size_voxels);

  std::vector<Level> levels_;
  std::size_t uploading_ = 0;  ///< the level of which slices are missing
  int uploaded_slices_ = 0;    ///< of that one
  double stored_scale_ = 1.0;  ///< texture units per stored number
  TissueRamp tissues_;
  EmptySpace empty_space_;
};

}  // namespace cutaway
