#include "benchmark/yardstick_task.h"

#include <cmath>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "scene/json.h"

namespace cutaway::benchmark {

namespace {

Json triple(glm::dvec3 v) { return {v.x, v.y, v.z}; }

void write(const std::filesystem::path& path, const void* data, std::size_t bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  file.close();
  if (!file) {
    throw Error({.code = ErrorCode::internal,
                 .message = "the yardstick's task cannot be written",
                 .field = path.string()});
  }
}

std::vector<std::int16_t> shorts_of(const Volume& volume) {
  using Limits = std::numeric_limits<std::int16_t>;
  if (volume.value_range.minimum < Limits::min() || volume.value_range.maximum > Limits::max()) {
    throw Error({.code = ErrorCode::out_of_range,
                 .message = "the yardstick takes volumes whose values are shorts",
                 .field = volume.description.id});
  }
  const glm::ivec3 size = volume.geometry.size_voxels;
  std::vector<std::int16_t> values;
  values.reserve(static_cast<std::size_t>(size.x) * size.y * size.z);
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i)
        values.push_back(static_cast<std::int16_t>(std::lround(value_at(volume, {i, j, k}))));
    }
  }
  return values;
}

Json task_of(const Volume& volume, const Scene& scene) {
  const VolumeGeometry& grid = volume.geometry;
  const glm::ivec3 size = grid.size_voxels;
  Json direction = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      direction.push_back(grid.direction_patient[column][row]);
  }
  return {{"volume", volume.description.id},
          {"size_voxels", {size.x, size.y, size.z}},
          {"spacing_mm", triple(grid.spacing_mm)},
          {"origin_mm", triple(grid.origin_patient_mm)},
          {"direction", direction},
          {"size_px", {scene.viewport.width_px, scene.viewport.height_px}},
          {"eye_mm", triple(scene.camera.eye_mm)},
          {"target_mm", triple(scene.camera.target_mm)},
          {"up", triple(scene.camera.up)},
          {"vertical_fov_degrees", scene.camera.vertical_fov_degrees},
          {"iso_value", scene.context.surface.band.lower},
          {"step_mm", smallest_spacing_mm(grid)}};
}

}  // namespace

void write_yardstick_task(const std::filesystem::path& folder, const Volume& volume,
                          const Scene& scene, const Silhouette& silhouette) {
  std::filesystem::create_directories(folder);
  const std::vector<std::int16_t> values = shorts_of(volume);
  write(folder / "voxels.raw", values.data(), values.size() * sizeof(values.front()));
  write(folder / "silhouette.raw", silhouette.pixels.data(), silhouette.pixels.size());
  const std::string task = task_of(volume, scene).dump(2);
  write(folder / "task.json", task.data(), task.size());
}

}  // namespace cutaway::benchmark
