// From a partial document to a scene in which nothing is left open.
#pragma once

#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// Checks a partial scene document against the schema. Throws Error naming the field (JSON pointer), the limit and what
/// came.
void validate_scene_document(const Json& document);

/// `base` changed by `patch` (RFC 7396 merge patch: null removes, arrays are replaced whole), except that a module (an
/// object with "name") of another name replaces the old one whole. Checks `patch` and the result; throws Error and leaves
/// nothing half done.
Json patch_scene_document(const Json& base, const Json& patch);

/// What the document says; what it leaves out from the schema's defaults; what those leave out chosen for the volume:
/// a camera that frames it from the front, the lens on the context surface in the middle of the view, iso-values.
/// Throws Error where the whole makes no sense (eye equal to target, up parallel to the view).
Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport);

/// The complete document of a resolved scene: resolve_scene of it gives the same scene again.
Json scene_document(const Scene& scene);

}  // namespace cutaway
