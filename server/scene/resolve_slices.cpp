#include "scene/resolve_slices.h"

#include "scene/refuse_scene.h"
#include "scene/scene_json.h"
#include "scene/volume_choices.h"

namespace cutaway {

namespace {

glm::dvec3 unit_direction(const Json& document, const char* key) {
  const glm::dvec3 direction = vector_from(document.at(key));
  if (glm::length(direction) >= kSmallestLength) return glm::normalize(direction);
  refuse_scene(std::string("/slices/") + key, "the direction has no length", "a direction",
               document.at(key));
}

glm::dvec3 square_to(glm::dvec3 superior, glm::dvec3 anterior, const Json& received) {
  const glm::dvec3 square = anterior - superior * glm::dot(anterior, superior);
  if (glm::length(square) >= kNearlyParallel) return glm::normalize(square);
  refuse_scene("/slices/anterior", "anterior runs along superior", "a direction across superior",
               received);
}

Window window_from(const Json& document, const VolumeFacts& volume) {
  return {document.value("centre", volume.window_centre),
          document.value("width", volume.window_width)};
}

SliceView view_from(const Json& document, glm::dvec3 chosen_centre_mm) {
  SliceView view{.centre_mm = vector_or(document, "centre_mm", [&] { return chosen_centre_mm; })};
  if (document.contains("view_height_mm"))
    view.view_height_mm = document.at("view_height_mm").get<double>();
  return view;
}

}  // namespace

Slices resolve_slices(const Json& document, const VolumeFacts& volume) {
  const glm::dvec3 middle_mm = slices_centre_mm(volume);
  Slices slices;
  slices.crosshair_mm =
      vector_or(document, "crosshair_mm", [&] { return chosen_crosshair_mm(volume); });
  slices.superior = unit_direction(document, "superior");
  slices.anterior =
      square_to(slices.superior, unit_direction(document, "anterior"), document.at("anterior"));
  slices.convention = document.at("convention").get<SliceConvention>();
  slices.window = window_from(document.at("window"), volume);
  slices.axial = view_from(document.at("axial"), middle_mm);
  slices.coronal = view_from(document.at("coronal"), middle_mm);
  slices.sagittal = view_from(document.at("sagittal"), middle_mm);
  return slices;
}

}  // namespace cutaway
