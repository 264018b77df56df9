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
                                       {LensCap::open, "open"},
                                       {LensCap::section, "section"}})
NLOHMANN_JSON_SERIALIZE_ENUM(LensOpening,
                             {{LensOpening::closed, "closed"}, {LensOpening::funnel, "funnel"}})
NLOHMANN_JSON_SERIALIZE_ENUM(NormalScale,
                             {{NormalScale::fixed, "fixed"}, {NormalScale::automatic, "auto"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Reconstruction,
                             {{Reconstruction::linear, "linear"}, {Reconstruction::cubic, "cubic"}})
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

inline Json vector_json(glm::dvec3 vector) { return Json::array({vector.x, vector.y, vector.z}); }

/// What a document says; the fields of which it says nothing are as a Scene{} has them.
Scene scene_from(const Json& document);
Viewport viewport_from(const Json& said);

Json module_json(const Module& module);

}  // namespace cutaway
