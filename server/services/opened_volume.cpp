#include "services/opened_volume.h"

#include <utility>

#include "render/loaded_facts.h"
#include "render/scene_preparation.h"
#include "scene/scene_json.h"

namespace cutaway {

namespace {

constexpr std::size_t kHistogramBinsSent = 256;
constexpr double kEdge = 1e-6;  // voxels; a point found on the grid's face is in it

Json size_json(glm::ivec3 size) { return Json::array({size.x, size.y, size.z}); }

Json axes_json(const glm::dmat3& axes) {
  return Json::array({vector_json(axes[0]), vector_json(axes[1]), vector_json(axes[2])});
}

Json histogram_json(const Histogram& histogram) {
  const std::size_t bins = histogram.counts.size();
  const std::size_t sent = std::min(bins, kHistogramBinsSent);
  std::vector<std::uint64_t> counts(sent, 0);
  for (std::size_t bin = 0; bin < bins; ++bin) counts[bin * sent / bins] += histogram.counts[bin];
  return counts;
}

Json summary_of(const LoadedVolume& loaded, const VolumeFacts& facts) {
  const VolumeDescription& description = loaded.volume.description;
  const VolumeGeometry& geometry = loaded.volume.geometry;
  return {{"id", description.id},
          {"title", description.title},
          {"modality", description.modality},
          {"units", description.units},
          {"size_voxels", size_json(geometry.size_voxels)},
          {"spacing_mm", vector_json(geometry.spacing_mm)},
          {"origin_mm", vector_json(geometry.origin_patient_mm)},
          {"axes", axes_json(geometry.direction_patient)},
          {"bounds_minimum_mm", vector_json(facts.bounds_minimum_mm)},
          {"bounds_maximum_mm", vector_json(facts.bounds_maximum_mm)},
          {"diagonal_mm", facts.diagonal_mm},
          {"value_range", {facts.minimum_value, facts.maximum_value}},
          {"outer_iso_value", facts.outer_iso_value},
          {"inner_iso_value", facts.inner_iso_value},
          {"histogram", histogram_json(loaded.histogram)},
          {"warnings", description.warnings}};
}

}  // namespace

OpenedVolume::OpenedVolume(const std::shared_ptr<const LoadedVolume>& loaded)
    : OpenedVolume(loaded, loaded) {}

OpenedVolume::OpenedVolume(std::shared_ptr<const LoadedVolume> loaded,
                           std::shared_ptr<const LoadedVolume> first_seen)
    : loaded_(std::move(loaded)),
      patient_to_index_(patient_to_index(loaded_->volume.geometry)),
      facts_(facts_of(*loaded_, first_seen)),
      summary_(summary_of(*loaded_, facts_)) {
  if (first_seen != loaded_)
    prepared_.put(preparation_of_first_look(*loaded_), std::move(first_seen));
}

std::shared_ptr<const LoadedVolume> OpenedVolume::seen_in(const Scene& scene) const {
  const VolumePreparation wanted = preparation_of(scene, *loaded_);
  if (wanted.is_nothing()) return loaded_;
  if (auto made = prepared_.find(wanted)) return made;
  if (auto near = prepared_.nearest(wanted)) return near;
  return loaded_;
}

SurfaceProbe OpenedVolume::probe(const Scene& scene) const { return probe_of(seen_in(scene)); }

std::optional<double> OpenedVolume::value_at(glm::dvec3 position_mm) const {
  return value_within(position_mm, kEdge);
}

std::optional<double> OpenedVolume::value_to_the_faces(glm::dvec3 position_mm) const {
  return value_within(position_mm, 0.5 + kEdge);
}

std::optional<double> OpenedVolume::value_within(glm::dvec3 position_mm, double beyond) const {
  const glm::dvec3 index(patient_to_index_ * glm::dvec4(position_mm, 1.0));
  const glm::dvec3 last(loaded_->volume.geometry.size_voxels - 1);
  const bool inside = glm::all(glm::greaterThanEqual(index, glm::dvec3(-beyond))) &&
                      glm::all(glm::lessThanEqual(index, last + beyond));
  if (!inside) return std::nullopt;
  return sample(loaded_->volume, index);
}

}  // namespace cutaway
