#include "render/gpu_volume.h"

#include <algorithm>

#include "core/error.h"
#include "gl/device_memory.h"
#include "render/texture_limit.h"

namespace cutaway {

namespace {

constexpr std::size_t kSlabBytes = std::size_t{8} << 20;

struct VoxelFormat {
  GLenum internal_format;
  GLenum type;
  std::size_t bytes;
  const std::uint8_t* data;
};

VoxelFormat voxel_format(const Voxels& voxels) {
  if (const auto* stored = std::get_if<std::vector<std::uint16_t>>(&voxels)) {
    return {GL_R16, GL_UNSIGNED_SHORT, 2, reinterpret_cast<const std::uint8_t*>(stored->data())};
  }
  const auto& floats = std::get<std::vector<float>>(voxels);
  return {GL_R32F, GL_FLOAT, 4, reinterpret_cast<const std::uint8_t*>(floats.data())};
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
    : loaded_(std::move(loaded)) {
  const glm::ivec3 size = volume().geometry.size_voxels;
  check_texture_limit(size, max_texture_size);
  const VoxelFormat format = voxel_format(volume().voxels);
  if (format.type == GL_UNSIGNED_SHORT) stored_scale_ = 1.0 / 65535.0;
  glGetError();  // what went wrong before is not this volume's
  texture_ = gl::Texture3D(format.internal_format, size, gl::Filtering::linear);
  check_device_memory();
}

std::uint64_t GpuVolume::texture_bytes(const Volume& volume) {
  const glm::u64vec3 size(volume.geometry.size_voxels);
  return size.x * size.y * size.z * voxel_format(volume.voxels).bytes;
}

void GpuVolume::upload_slab() {
  const glm::ivec3 size = volume().geometry.size_voxels;
  const VoxelFormat format = voxel_format(volume().voxels);
  const std::size_t slice_bytes = format.bytes * static_cast<std::size_t>(size.x) * size.y;
  const int slab = std::max(1, static_cast<int>(kSlabBytes / slice_bytes));
  const int count = std::min(slab, size.z - uploaded_slices_);
  texture_.upload_slices(uploaded_slices_, count, GL_RED, format.type,
                         format.data + slice_bytes * uploaded_slices_);
  check_device_memory();
  uploaded_slices_ += count;
}

void GpuVolume::upload_rest() {
  while (!is_complete()) upload_slab();
}

double GpuVolume::uploaded() const {
  return static_cast<double>(uploaded_slices_) / volume().geometry.size_voxels.z;
}

float GpuVolume::to_stored(double physical_value) const {
  return static_cast<float>((physical_value - volume().value_offset) / volume().value_scale *
                            stored_scale_);
}

void GpuVolume::set_uniforms(const gl::Program& program, int unit) const {
  const VolumeGeometry& geometry = volume().geometry;
  program.set_texture("volume_texture", unit, texture_.name());
  const glm::dvec3 size(geometry.size_voxels);
  program.set("voxel_size", glm::vec3(1.0 / size));
  program.set("volume_size_mm", glm::vec3(size * geometry.spacing_mm));
  program.set("volume_direction", glm::mat3(geometry.direction_patient));
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
