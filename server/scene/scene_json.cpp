#include "scene/scene_json.h"

#include "scene/resolve.h"

namespace cutaway {

namespace {

Json json_from(const Camera& camera) {
  return {{"projection", camera.projection},
          {"eye_mm", vector_json(camera.eye_mm)},
          {"target_mm", vector_json(camera.target_mm)},
          {"up", vector_json(camera.up)},
          {"vertical_fov_degrees", camera.vertical_fov_degrees},
          {"view_height_mm", camera.view_height_mm}};
}

Json json_from(const Surface& surface) {
  Json object{{"iso_value", surface.band.lower}, {"opacity", surface.opacity}};
  if (surface.band.has_upper_end()) object["upper_value"] = surface.band.upper;
  return object;
}

Json json_from(const Branch& branch) {
  Json filters = Json::array();
  for (const Module& filter : branch.filters) filters.push_back(module_json(filter));
  return {{"surface", json_from(branch.surface)},
          {"shading", module_json(branch.shading)},
          {"filters", std::move(filters)}};
}

Json json_from(const Lens& lens) {
  return {{"mode", lens.mode},
          {"shape", module_json(lens.shape)},
          {"centre_mm", vector_json(lens.centre_mm)},
          {"radius_mm", lens.radius_mm},
          {"cap", lens.cap},
          {"strength", lens.strength},
          {"softness", lens.softness},
          {"strict", lens.strict}};
}

Json json_from(const Light& light) {
  return {{"frame", light.frame}, {"direction", vector_json(light.direction)}};
}

Json json_from(const SliceView& view) {
  Json object{{"centre_mm", vector_json(view.centre_mm)}};
  if (view.view_height_mm) object["view_height_mm"] = *view.view_height_mm;
  return object;
}

Json json_from(const Slices& slices) {
  return {{"crosshair_mm", vector_json(slices.crosshair_mm)},
          {"superior", vector_json(slices.superior)},
          {"anterior", vector_json(slices.anterior)},
          {"convention", slices.convention},
          {"window", {{"centre", slices.window.centre}, {"width", slices.window.width}}},
          {"axial", json_from(slices.axial)},
          {"coronal", json_from(slices.coronal)},
          {"sagittal", json_from(slices.sagittal)}};
}

}  // namespace

Module module_from(const Json& object) {
  Module module{object.at("name").get<std::string>(), object};
  module.parameters.erase("name");
  return module;
}

Json module_json(const Module& module) {
  Json object = module.parameters;
  object["name"] = module.name;
  return object;
}

Json scene_document(const Scene& scene) {
  return {{"version", 1},
          {"volume", scene.volume},
          {"camera", json_from(scene.camera)},
          {"focus", json_from(scene.focus)},
          {"context", json_from(scene.context)},
          {"lens", json_from(scene.lens)},
          {"light", json_from(scene.light)},
          {"background", {{"colour", vector_json(scene.background.colour)}}},
          {"slices", json_from(scene.slices)}};
}

}  // namespace cutaway
