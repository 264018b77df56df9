#include "support/made_ct.h"

#include <cmath>

#include "volume/voxel_packing.h"

namespace cutaway::test {

double hashed(std::uint64_t place) {
  std::uint64_t x = place + 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  x ^= x >> 31;
  return double(x >> 11) / double(std::uint64_t{1} << 52) - 1.0;
}

MadeCt made_ct(const VolumeGeometry& geometry, double noise_hu,
               const std::function<MadePlace(glm::dvec3)>& place) {
  MadeCt made;
  const glm::ivec3 size = geometry.size_voxels;
  const glm::dmat4 to_patient = index_to_patient(geometry);
  std::vector<float> values;
  for (int z = 0; z < size.z; ++z) {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const MadePlace here = place(glm::dvec3(to_patient * glm::dvec4(x, y, z, 1.0)));
        // Evenly spread numbers of this width have a standard deviation of 1.
        const double noise = std::sqrt(3.0) * hashed(values.size()) * noise_hu;
        values.push_back(float(std::round(here.hu + noise)));
        made.body.push_back(here.is_body ? 1 : 0);
        made.couch.push_back(here.is_couch ? 1 : 0);
      }
    }
  }
  PackedVoxels packed = pack_voxels(std::span<const float>(values));
  made.volume.description.modality = "CT";
  made.volume.description.units = "HU";
  made.volume.geometry = geometry;
  made.volume.voxels = std::move(packed.voxels);
  made.volume.value_scale = packed.value_scale;
  made.volume.value_offset = packed.value_offset;
  made.volume.value_range = packed.value_range;
  return made;
}

namespace {

double ellipse(glm::dvec2 p, glm::dvec2 half) { return glm::length(p / half); }

MadePlace tissue(double hu) { return {.hu = hu, .is_body = true}; }

}  // namespace

MadePlace made_torso(glm::dvec3 p) {
  const glm::dvec2 across(p.x, p.y);
  if (ellipse(across, {110.0, 75.0}) > 1.0) return {};
  if (ellipse(across - glm::dvec2(0.0, 45.0), {18.0, 16.0}) < 1.0) return tissue(700.0);
  const double ribs = ellipse(across, {96.0, 61.0});
  if (ribs > 0.93 && ribs < 1.0 && std::fmod(p.z + 1000.0, 24.0) < 9.0) return tissue(600.0);
  if (ellipse({std::abs(p.x) - 50.0, p.y + 5.0}, {30.0, 38.0}) < 1.0) return tissue(-850.0);
  return ellipse(across, {100.0, 65.0}) > 1.0 ? tissue(-100.0) : tissue(50.0);
}

std::function<MadePlace(glm::dvec3)> any_of(
    std::vector<std::function<MadePlace(glm::dvec3)>> places) {
  return [places = std::move(places)](glm::dvec3 p) {
    for (const auto& place : places) {
      const MadePlace here = place(p);
      if (here.is_body || here.is_couch) return here;
    }
    return MadePlace{};
  };
}

std::function<MadePlace(glm::dvec3)> made_couch(double gap_mm, double thickness_mm, double hu) {
  return [=](glm::dvec3 p) {
    const double depth_mm = p.y - 75.0 - gap_mm;
    const bool holds = depth_mm >= 0.0 && depth_mm < thickness_mm && std::abs(p.x) < 140.0;
    return holds ? MadePlace{.hu = hu, .is_couch = true} : MadePlace{};
  };
}

}  // namespace cutaway::test
