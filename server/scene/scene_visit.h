// Each value type of a scene, field by field, under the names that a document gives them: what
// reads, writes and compares goes through here.
#pragma once

#include <concepts>
#include <type_traits>

#include "scene/scene.h"

namespace cutaway {

template <typename T, typename Struct>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Struct>;

// visit(name, value) for each field.

void visit_fields(MaybeConst<Camera> auto& camera, const auto& visit) {
  visit("projection", camera.projection);
  visit("eye_mm", camera.eye_mm);
  visit("target_mm", camera.target_mm);
  visit("up", camera.up);
  visit("vertical_fov_degrees", camera.vertical_fov_degrees);
  visit("view_height_mm", camera.view_height_mm);
}

void visit_fields(MaybeConst<Viewport> auto& viewport, const auto& visit) {
  visit("kind", viewport.kind);
  visit("width_px", viewport.width_px);
  visit("height_px", viewport.height_px);
}

/// An upper end that is infinite is none.
void visit_fields(MaybeConst<Surface> auto& surface, const auto& visit) {
  visit("iso_value", surface.band.lower);
  visit("upper_value", surface.band.upper);
  visit("opacity", surface.opacity);
}

void visit_fields(MaybeConst<Normals> auto& normals, const auto& visit) {
  visit("scale", normals.scale);
  visit("scale_mm", normals.scale_mm);
  visit("reconstruction", normals.reconstruction);
}

void visit_fields(MaybeConst<Occlusion> auto& occlusion, const auto& visit) {
  visit("strength", occlusion.strength);
  visit("range_mm", occlusion.range_mm);
  visit("near_share", occlusion.near_share);
  visit("colour", occlusion.colour);
}

void visit_fields(MaybeConst<Shadow> auto& shadow, const auto& visit) {
  visit("strength", shadow.strength);
  visit("softness_degrees", shadow.softness_degrees);
}

void visit_fields(MaybeConst<Preparation> auto& preparation, const auto& visit) {
  visit("hide_couch", preparation.hide_couch);
  visit("fill_context", preparation.fill_context);
  visit("focus_islands_ml", preparation.focus_islands_ml);
  visit("context_islands_ml", preparation.context_islands_ml);
}

void visit_fields(MaybeConst<Branch> auto& branch, const auto& visit) {
  visit("surface", branch.surface);
  visit("shading", branch.shading);
  visit("normals", branch.normals);
  visit("occlusion", branch.occlusion);
  visit("shadow", branch.shadow);
  visit("filters", branch.filters);
}

void visit_fields(MaybeConst<Wall> auto& wall, const auto& visit) {
  visit("strength", wall.strength);
  visit("colour", wall.colour);
  visit("deepening", wall.deepening);
  visit("edge_mm", wall.edge_mm);
  visit("edge_colour", wall.edge_colour);
}

void visit_fields(MaybeConst<Lens> auto& lens, const auto& visit) {
  visit("mode", lens.mode);
  visit("shape", lens.shape);
  visit("centre_mm", lens.centre_mm);
  visit("radius_mm", lens.radius_mm);
  visit("opening", lens.opening);
  visit("funnel_degrees", lens.funnel_degrees);
  visit("cap", lens.cap);
  visit("wall", lens.wall);
  visit("strength", lens.strength);
  visit("softness", lens.softness);
  visit("strict", lens.strict);
}

void visit_fields(MaybeConst<Light> auto& light, const auto& visit) {
  visit("frame", light.frame);
  visit("direction", light.direction);
}

void visit_fields(MaybeConst<Background> auto& background, const auto& visit) {
  visit("colour", background.colour);
}

void visit_fields(MaybeConst<Window> auto& window, const auto& visit) {
  visit("centre", window.centre);
  visit("width", window.width);
}

void visit_fields(MaybeConst<SliceView> auto& view, const auto& visit) {
  visit("centre_mm", view.centre_mm);
  visit("view_height_mm", view.view_height_mm);
}

void visit_fields(MaybeConst<Slices> auto& slices, const auto& visit) {
  visit("crosshair_mm", slices.crosshair_mm);
  visit("superior", slices.superior);
  visit("anterior", slices.anterior);
  visit("convention", slices.convention);
  visit("window", slices.window);
  visit("axial", slices.axial);
  visit("coronal", slices.coronal);
  visit("sagittal", slices.sagittal);
}

/// All but the viewport, which is not the document's to say in a session.
void visit_fields(MaybeConst<Scene> auto& scene, const auto& visit) {
  visit("volume", scene.volume);
  visit("camera", scene.camera);
  visit("preparation", scene.preparation);
  visit("focus", scene.focus);
  visit("context", scene.context);
  visit("lens", scene.lens);
  visit("light", scene.light);
  visit("background", scene.background);
  visit("slices", scene.slices);
}

}  // namespace cutaway
