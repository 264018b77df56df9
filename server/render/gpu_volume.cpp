#include "render/gpu_volume.h"

#include <algorithm>
#include <span>

#include "core/error.h"
#include "gl/device_memory.h"
#include "render/texture_limit.h"

namespace cutaway {

namespace {

/// Above every stored value.
constexpr float kNoUpperLimit = 3e38F;

constexpr std::size_t kSlabBytes = std::size_t{8} << 20;

GLenum internal_format(const Voxels& voxels) {
  return std::holds_alternative<std::vector<float>>(voxels) ? GL_R32F : GL_R16;
}

std::span<const std::byte> bytes_of(const Voxels& voxels) {
  return std::visit([](const auto& values) { return std::as_bytes(std::span(values)); }, voxels);
}

// A device says so once, at the call that it could not serve.
void check_device_memory() {
  if (!gl::ran_out_of_memory()) return;
  throw Error({.code = ErrorCode::too_large,
               .message = "the renderer has not enough memory for this volume",
               .field = "/volume"});
}

}  // namespace

GpuVolume::GpuVolume(std::shared_ptr<const LoadedVolume> loaded, int max_texture_size)
    : loaded_(std::move(loaded)), tissues_(tissue_ramp(*loaded_)) {
  const glm::ivec3 size = volume().geometry.size_voxels;
  check_texture_limit(size, max_texture_size);
  if (internal_format(volume().voxels) == GL_R16) stored_scale_ = 1.0 / 65535.0;
  glGetError();  // what went wrong before is not this volume's
  add_level(volume().voxels, glm::ivec3(1), size);
  for (const CoarseLevel& level : loaded_->pyramid)
    add_level(level.voxels, level.factor, level.size_voxels);
  check_device_memory();
}

void GpuVolume::add_level(const Voxels& voxels, glm::ivec3 factor, glm::ivec3 size_voxels) {
  levels_.push_back({&voxels, factor,
                     gl::Texture3D(internal_format(voxels), size_voxels, gl::Filtering::linear)});
}

std::uint64_t GpuVolume::texture_bytes(const LoadedVolume& loaded) {
  return byte_size(loaded.volume) + byte_size(loaded.pyramid);
}

// A small copy goes with what came before it.
void GpuVolume::upload_slab() {
  std::size_t bytes = 0;
  while (bytes < kSlabBytes && !is_complete()) bytes += upload_slices(kSlabBytes - bytes);
}

std::size_t GpuVolume::upload_slices(std::size_t most_bytes) {
  Level& level = levels_.at(uploading_);
  const glm::ivec3 size = level.texture.size_texels();
  const std::span<const std::byte> bytes = bytes_of(*level.voxels);
  const std::size_t slice_bytes = std::max<std::size_t>(1, bytes.size() / size.z);
  const int slab = std::max(1, static_cast<int>(most_bytes / slice_bytes));
  const int count = std::min(slab, size.z - uploaded_slices_);
  level.texture.upload_slices(uploaded_slices_, count, bytes);
  check_device_memory();
  uploaded_slices_ += count;
  if (uploaded_slices_ == size.z) {
    uploaded_slices_ = 0;
    ++uploading_;
  }
  return slice_bytes * count;
}

void GpuVolume::upload_rest() {
  while (!is_complete()) upload_slab();
}

double GpuVolume::uploaded() const {
  double all = 0.0;
  double done = 0.0;
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const glm::dvec3 size(levels_[i].texture.size_texels());
    all += size.x * size.y * size.z;
    done += size.x * size.y * (i < uploading_ ? size.z : i == uploading_ ? uploaded_slices_ : 0.0);
  }
  return done / all;
}

float GpuVolume::to_stored(double physical_value) const {
  return static_cast<float>((physical_value - volume().value_offset) / volume().value_scale *
                            stored_scale_);
}

glm::vec2 GpuVolume::to_stored(const ValueBand& band) const {
  return {to_stored(band.lower), band.has_upper_end() ? to_stored(band.upper) : kNoUpperLimit};
}

void GpuVolume::set_uniforms(const gl::Program& program, int unit) const {
  const VolumeGeometry& geometry = volume().geometry;
  program.set_texture("volume_texture", unit, levels_.front().texture.name());
  const glm::dvec3 size(geometry.size_voxels);
  program.set("voxel_size", glm::vec3(1.0 / size));
  program.set("volume_size_mm", glm::vec3(size * geometry.spacing_mm));
  program.set("volume_direction", glm::mat3(geometry.direction_patient));
}

std::vector<glm::ivec3> GpuVolume::level_factors() const {
  std::vector<glm::ivec3> factors;
  factors.reserve(levels_.size());
  for (const Level& level : levels_) factors.push_back(level.factor);
  return factors;
}

void GpuVolume::set_level(const gl::Program& program, int unit, std::size_t number) const {
  const Level& level = levels_.at(number);
  program.set_texture("coarse_texture", unit, level.texture.name());
  // The last texel may reach beyond the volume.
  const glm::vec3 spanned(level.texture.size_texels() * level.factor);
  program.set("coarse_from_volume", glm::vec3(volume().geometry.size_voxels) / spanned);
}

void GpuVolume::set_empty_space(const gl::Program& program, int unit,
                                const EmptySpaceMaps& maps) const {
  program.set_texture("distance_maps", unit, maps.distances.name());
  const MinMaxGrid& grid = loaded_->min_max;
  program.set("map_size", glm::vec3(grid.size_bricks));
  program.set("bricks_per_volume",
              glm::vec3(volume().geometry.size_voxels) / static_cast<float>(grid.brick_size));
  program.set("first_centre_bricks", 0.5F / static_cast<float>(grid.brick_size));
}

}  // namespace cutaway
