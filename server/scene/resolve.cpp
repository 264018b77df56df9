#include "scene/resolve.h"

#include <algorithm>

#include "core/error.h"
#include "scene/admitted.h"
#include "scene/json_text.h"
#include "scene/module_aliases.h"
#include "scene/refuse_scene.h"
#include "scene/resolve_slices.h"
#include "scene/scene_json.h"
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

Camera resolve_camera(const Json& document, const VolumeFacts& volume, Viewport viewport) {
  Camera camera;
  camera.projection = document.at("projection").get<Projection>();
  camera.vertical_fov_degrees = document.at("vertical_fov_degrees").get<double>();
  camera.view_height_mm = document.contains("view_height_mm")
                              ? document.at("view_height_mm").get<double>()
                              : chosen_view_height_mm(volume, viewport);
  camera.target_mm = vector_or(document, "target_mm", [&] { return volume_centre_mm(volume); });
  camera.eye_mm = vector_or(document, "eye_mm", [&] {
    return chosen_eye_mm(volume, viewport, camera.target_mm, camera.vertical_fov_degrees);
  });
  camera.up =
      vector_or(document, "up", [&] { return chosen_up(camera.target_mm - camera.eye_mm); });
  check_camera(camera);
  return camera;
}

double iso_value_of(const Json& surface, double chosen) {
  if (surface.contains("iso_value")) return surface.at("iso_value").get<double>();
  const NumberRange range =
      number_range("scene", "/properties/focus/properties/surface/properties/iso_value");
  return std::clamp(chosen, range.minimum, range.maximum);
}

Surface resolve_surface(const Json& document, double chosen_iso_value, const std::string& branch) {
  Surface surface;
  surface.band.lower = iso_value_of(document, chosen_iso_value);
  surface.opacity = document.at("opacity").get<double>();
  if (!document.contains("upper_value")) return surface;
  surface.band.upper = document.at("upper_value").get<double>();
  if (surface.band.upper > surface.band.lower) return surface;
  refuse_scene(("/" + branch + "/surface/upper_value").c_str(), "the band is empty",
               ("a value above iso_value, which is " + json_text(surface.band.lower)).c_str(),
               document.at("upper_value"));
}

void refuse_repeated_filters(const std::vector<Module>& filters, const std::string& branch) {
  for (std::size_t i = 0; i < filters.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (filters[i].name != filters[k].name) continue;
      refuse_scene(("/" + branch + "/filters/" + std::to_string(i)).c_str(),
                   "the filter is there twice", "each filter once", filters[i].name);
    }
  }
}

Branch resolve_branch(const Json& document, double chosen_iso_value, const std::string& name) {
  Branch branch;
  branch.surface = resolve_surface(document.at("surface"), chosen_iso_value, name);
  branch.shading = module_from(document.at("shading"));
  for (const Json& filter : document.at("filters")) branch.filters.push_back(module_from(filter));
  refuse_repeated_filters(branch.filters, name);
  return branch;
}

Lens resolve_lens(const Json& document, const VolumeFacts& volume, const Scene& scene,
                  LensMemory& lenses) {
  Lens lens;
  lens.mode = document.at("mode").get<LensMode>();
  lens.shape = module_from(document.at("shape"));
  lens.cap = document.at("cap").get<LensCap>();
  lens.strength = document.at("strength").get<double>();
  lens.softness = document.at("softness").get<double>();
  lens.strict = document.at("strict").get<bool>();
  if (document.contains("radius_mm")) lens.radius_mm = document.at("radius_mm").get<double>();
  if (document.contains("centre_mm")) lens.centre_mm = vector_from(document.at("centre_mm"));
  if (document.contains("radius_mm") && document.contains("centre_mm")) return lens;
  const LensPlacementView view{scene.camera, scene.viewport, scene.context.surface.band,
                               scene.focus.surface.band};
  const PlacedLens chosen = lenses.lens(
      volume, view, document.contains("radius_mm") ? std::optional(lens.radius_mm) : std::nullopt);
  if (!document.contains("radius_mm")) lens.radius_mm = chosen.radius_mm;
  if (!document.contains("centre_mm")) lens.centre_mm = chosen.centre_mm;
  return lens;
}

Light resolve_light(const Json& document) {
  const Light light{document.at("frame").get<LightFrame>(), vector_from(document.at("direction"))};
  if (glm::length(light.direction) < kSmallestLength)
    refuse_scene("/light/direction", "the light has no direction", "a direction",
                 vector_json(light.direction));
  return light;
}

}  // namespace

void validate_scene_document(const Json& document) { validate(document, "scene"); }

Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport) {
  LensMemory lenses;
  return resolve_scene(document, volume, viewport, lenses);
}

namespace {

Scene with_choices(const Json& document, const VolumeFacts& volume, Viewport viewport,
                   LensMemory& lenses) {
  const Json complete = with_defaults(without_aliases(document), "scene");
  Scene scene;
  scene.volume = complete.value("volume", volume.id);
  scene.viewport = viewport;
  scene.camera = resolve_camera(complete.at("camera"), volume, viewport);
  scene.focus = resolve_branch(complete.at("focus"), volume.inner_iso_value, "focus");
  scene.context = resolve_branch(complete.at("context"), volume.outer_iso_value, "context");
  scene.light = resolve_light(complete.at("light"));
  scene.slices = resolve_slices(complete.at("slices"), volume);
  scene.background.colour = vector_from(complete.at("background").at("colour"));
  scene.lens = resolve_lens(complete.at("lens"), volume, scene, lenses);  // last: it may look long
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
  const Json viewport = with_defaults(document, "scene").at("viewport");
  return {viewport.at("width_px").get<int>(), viewport.at("height_px").get<int>(),
          viewport.at("kind").get<ViewKind>()};
}

}  // namespace cutaway
