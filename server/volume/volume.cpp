#include "volume/volume.h"

#include <cstddef>

namespace cutaway {

namespace {

double stored_at(const Voxels& voxels, std::size_t offset) {
  return std::visit([offset](const auto& values) { return double(values[offset]); }, voxels);
}

std::size_t offset_of(glm::ivec3 index, glm::ivec3 size) {
  return (std::size_t(index.z) * size.y + index.y) * size.x + index.x;
}

}  // namespace

double value_at(const Volume& volume, glm::ivec3 index) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  const glm::ivec3 inside = glm::clamp(index, glm::ivec3(0), size - 1);
  return stored_at(volume.voxels, offset_of(inside, size)) * volume.value_scale +
         volume.value_offset;
}

double sample(const Volume& volume, glm::dvec3 index) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  const glm::dvec3 inside = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(size - 1));
  const glm::ivec3 low = glm::ivec3(glm::floor(inside));
  const glm::dvec3 fraction = inside - glm::dvec3(low);
  const auto along_x = [&](int y, int z) {
    return glm::mix(value_at(volume, low + glm::ivec3(0, y, z)),
                    value_at(volume, low + glm::ivec3(1, y, z)), fraction.x);
  };
  const auto along_y = [&](int z) { return glm::mix(along_x(0, z), along_x(1, z), fraction.y); };
  return glm::mix(along_y(0), along_y(1), fraction.z);
}

std::size_t byte_size(const Volume& volume) {
  return std::visit([](const auto& values) { return values.size() * sizeof(values[0]); },
                    volume.voxels);
}

}  // namespace cutaway
