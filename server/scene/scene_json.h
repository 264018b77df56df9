// The words of a scene document for each value type.
#pragma once

#include "scene/scene.h"

namespace cutaway {

NLOHMANN_JSON_SERIALIZE_ENUM(Projection, {{Projection::perspective, "perspective"},
                                          {Projection::orthographic, "orthographic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(LensMode, {{LensMode::none, "none"},
                                        {LensMode::cutaway, "cutaway"},
                                        {LensMode::magic, "magic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(LensCap, {{LensCap::flat, "flat"},
                                       {LensCap::gradient, "gradient"},
                                       {LensCap::open, "open"}})
NLOHMANN_JSON_SERIALIZE_ENUM(LightFrame,
                             {{LightFrame::camera, "camera"}, {LightFrame::patient, "patient"}})
NLOHMANN_JSON_SERIALIZE_ENUM(ViewKind, {{ViewKind::volume, "3d"},
                                        {ViewKind::axial, "axial"},
                                        {ViewKind::coronal, "coronal"},
                                        {ViewKind::sagittal, "sagittal"}})
NLOHMANN_JSON_SERIALIZE_ENUM(SliceConvention, {{SliceConvention::radiological, "radiological"},
                                               {SliceConvention::neurological, "neurological"}})

inline glm::dvec3 vector_from(const Json& array) {
  return {array.at(0).get<double>(), array.at(1).get<double>(), array.at(2).get<double>()};
}

/// What the object says at the key, or what `choose` gives.
template <typename Choose>
glm::dvec3 vector_or(const Json& object, const char* key, const Choose& choose) {
  return object.contains(key) ? vector_from(object.at(key)) : choose();
}

inline Json vector_json(glm::dvec3 vector) { return Json::array({vector.x, vector.y, vector.z}); }

Module module_from(const Json& object);
Json module_json(const Module& module);

}  // namespace cutaway
