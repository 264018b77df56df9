#include "scene/resolve.h"

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "core/error.h"
#include "scene/admitted.h"
#include "scene/json_text.h"
#include "scene/module_aliases.h"
#include "scene/refuse_scene.h"
#include "scene/relative_lengths.h"
#include "scene/resolve_slices.h"
#include "scene/scene_json.h"
#include "scene/scene_visit.h"
#include "scene/schema.h"
#include "scene/volume_choices.h"

namespace cutaway {

namespace {

constexpr double kSmallestDistance_mm = 1e-9;

void check_camera(const Camera& camera) {
  const glm::dvec3 view = camera.target_mm - camera.eye_mm;
  if (glm::length(view) < kSmallestDistance_mm)
    refuse_scene("/camera/eye_mm", "the eye is at the target", "two points that differ",
                 vector_json(camera.eye_mm));
  if (glm::length(camera.up) < kSmallestLength)
    refuse_scene("/camera/up", "up has no length", "a direction", vector_json(camera.up));
  const glm::dvec3 across = glm::cross(glm::normalize(view), glm::normalize(camera.up));
  if (glm::length(across) < kNearlyParallel)
    refuse_scene("/camera/up", "up runs along the view", "a direction across the view",
                 vector_json(camera.up));
}

void complete_camera(Camera& camera, const Json& said, const VolumeFacts& volume,
                     Viewport viewport) {
  if (!said.contains("view_height_mm"))
    camera.view_height_mm = chosen_view_height_mm(volume, viewport);
  if (!said.contains("target_mm")) camera.target_mm = volume_centre_mm(volume);
  if (!said.contains("eye_mm"))
    camera.eye_mm = chosen_eye_mm(volume, viewport, camera.target_mm, camera.vertical_fov_degrees);
  if (!said.contains("up")) camera.up = chosen_up(volume, camera.target_mm - camera.eye_mm);
  check_camera(camera);
}

double chosen_iso_value(double value) {
  const NumberRange range =
      number_range("scene", "/properties/focus/properties/surface/properties/iso_value");
  return std::clamp(value, range.minimum, range.maximum);
}

void complete_surface(Surface& surface, const Json& said, double iso_value,
                      const std::string& branch) {
  if (!said.contains("iso_value")) surface.band.lower = chosen_iso_value(iso_value);
  if (!said.contains("upper_value") || surface.band.upper > surface.band.lower) return;
  refuse_scene("/" + branch + "/surface/upper_value", "the band is empty",
               "a value above iso_value, which is " + json_text(surface.band.lower),
               said.at("upper_value"));
}

void refuse_repeated_filters(const std::vector<Module>& filters, const std::string& branch) {
  for (std::size_t i = 0; i < filters.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (filters[i].name != filters[k].name) continue;
      refuse_scene("/" + branch + "/filters/" + std::to_string(i), "the filter is there twice",
                   "each filter once", filters[i].name);
    }
  }
}

void complete_branch(Branch& branch, const Json& said, double iso_value, const std::string& name) {
  complete_surface(branch.surface, said.at("surface"), iso_value, name);
  refuse_repeated_filters(branch.filters, name);
}

void complete_lens(Scene& scene, const Json& said, const VolumeFacts& volume, LensMemory& lenses) {
  const bool has_radius = said.contains("radius_mm");
  const bool has_centre = said.contains("centre_mm");
  if (has_radius && has_centre) return;
  const LensPlacementView view{scene.camera, scene.viewport, scene.context.surface.band,
                               scene.focus.surface.band, scene.lens.shape};
  const PlacedLens chosen =
      lenses.lens(volume, view, has_radius ? std::optional(scene.lens.radius_mm) : std::nullopt);
  if (!has_radius) scene.lens.radius_mm = chosen.radius_mm;
  if (!has_centre) scene.lens.centre_mm = chosen.centre_mm;
}

/// A document that says which surface it shows, and nothing of a preparation, is of a time that
/// knew none.
void complete_preparation(Preparation& preparation, const Json& said, const VolumeFacts& volume) {
  if (said.at("context").at("surface").contains("iso_value")) return;
  const Json& fields = said.at("preparation");
  Preparation chosen = volume.first_preparation;
  visit_fields(chosen, [&](const char* name, const auto& value) {
    visit_fields(preparation, [&](const char* open, auto& field) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::decay_t<decltype(field)>>)
        if (std::string_view(name) == open && !fields.contains(name)) field = value;
    });
  });
}

void check_light(const Light& light) {
  if (glm::length(light.direction) < kSmallestLength)
    refuse_scene("/light/direction", "the light has no direction", "a direction",
                 vector_json(light.direction));
}

}  // namespace

void validate_scene_document(const Json& document) {
  validate(document, "scene");
  refuse_both_lengths(document);
}

Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport) {
  LensMemory lenses;
  return resolve_scene(document, volume, viewport, lenses);
}

namespace {

Scene with_choices(const Json& document, const VolumeFacts& volume, Viewport viewport,
                   LensMemory& lenses) {
  const Json named = without_aliases(document);
  refuse_both_lengths(named);
  const Json said = with_defaults(named, "scene");
  Scene scene = scene_from(said);
  if (!said.contains("volume")) scene.volume = volume.id;
  scene.viewport = viewport;
  complete_camera(scene.camera, said.at("camera"), volume, viewport);
  complete_preparation(scene.preparation, said, volume);
  complete_branch(scene.focus, said.at("focus"), volume.inner_iso_value, "focus");
  complete_branch(scene.context, said.at("context"), volume.outer_iso_value, "context");
  check_light(scene.light);
  complete_slices(scene.slices, said.at("slices"), volume);
  complete_lens(scene, said.at("lens"), volume, lenses);  // last: it may look long
  return scene;
}

}  // namespace

// What was chosen becomes the session's document, and has to be one that is accepted again.
Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport,
                    LensMemory& lenses) {
  validate_scene_document(document);
  const Scene scene = with_choices(document, volume, viewport, lenses);
  const Json complete = scene_document(scene);
  const Json legal = admitted(complete, "scene");
  return legal == complete ? scene : with_choices(legal, volume, viewport, lenses);
}

Viewport document_viewport(const Json& document) {
  validate_scene_document(document);
  return viewport_from(with_defaults(document, "scene").at("viewport"));
}

}  // namespace cutaway
