#include "scene/resolve_slices.h"

#include "scene/refuse_scene.h"
#include "scene/scene_json.h"
#include "scene/volume_choices.h"

namespace cutaway {

namespace {

glm::dvec3 unit(glm::dvec3 direction, const char* field) {
  if (glm::length(direction) >= kSmallestLength) return glm::normalize(direction);
  refuse_scene(std::string("/slices/") + field, "the direction has no length", "a direction",
               vector_json(direction));
}

glm::dvec3 square_to(glm::dvec3 superior, glm::dvec3 anterior, const Json& received) {
  const glm::dvec3 square = anterior - superior * glm::dot(anterior, superior);
  if (glm::length(square) >= kNearlyParallel) return glm::normalize(square);
  refuse_scene("/slices/anterior", "anterior runs along superior", "a direction across superior",
               received);
}

void complete_view(SliceView& view, const Json& said, glm::dvec3 chosen_centre_mm) {
  if (!said.contains("centre_mm")) view.centre_mm = chosen_centre_mm;
}

}  // namespace

void complete_slices(Slices& slices, const Json& said, const VolumeFacts& volume) {
  const glm::dvec3 middle_mm = slices_centre_mm(volume);
  if (!said.contains("crosshair_mm")) slices.crosshair_mm = chosen_crosshair_mm(volume);
  slices.superior = unit(slices.superior, "superior");
  slices.anterior =
      square_to(slices.superior, unit(slices.anterior, "anterior"), said.at("anterior"));
  if (!said.at("window").contains("centre")) slices.window.centre = volume.window_centre;
  if (!said.at("window").contains("width")) slices.window.width = volume.window_width;
  complete_view(slices.axial, said.at("axial"), middle_mm);
  complete_view(slices.coronal, said.at("coronal"), middle_mm);
  complete_view(slices.sagittal, said.at("sagittal"), middle_mm);
}

}  // namespace cutaway
