// From a partial document to a scene in which nothing is left open.
//
// How a session uses it: once a volume is open, resolve its document and keep scene_document() of
// the result as the new document. Every patch is then merged into that complete document, so what
// was chosen once (the lens on the surface in the middle of the first view) stays where it is while
// only the camera moves; a field that a patch sets to null is open again and chosen anew by the
// next resolve. Before another volume is shown, without_volume_choices() opens what was chosen for
// the old one.
//
// All functions are thread-safe, each memory on one thread at a time.
#pragma once

#include "scene/lens_memory.h"
#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// Checks a partial scene document against the schema. Throws Error naming the field (JSON
/// pointer), the limit and what came.
void validate_scene_document(const Json& document);

/// `base` changed by `patch` (RFC 7396 merge patch: null removes, arrays are replaced whole),
/// except that a module (an object with "name") of another name replaces the old one whole. Checks
/// `patch` and the result; throws Error and leaves nothing half done.
Json patch_scene_document(const Json& base, const Json& patch);

/// The document without what means nothing in another volume: its id, places, lengths and values.
/// How wide the camera sees and how much of the lens is seen stay.
Json without_volume_choices(Json document);

/// What the document says; what it leaves out from the schema's defaults; what those leave out
/// chosen for the volume: a camera that frames it from the front, the lens on the context surface
/// in the middle of the view, iso-values; where the context's is left out, what the volume goes
/// through before it is drawn. A viewport of 0x0 (not known yet) frames for a square.
/// The document's own "viewport" is ignored. Throws Error where the whole makes no sense (eye equal
/// to target, up parallel to the view).
Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport);
/// The same; a lens that the document leaves open comes from the memory where that knows it.
Scene resolve_scene(const Json& document, const VolumeFacts& volume, Viewport viewport,
                    LensMemory& lenses);

/// The complete document of a resolved scene: resolve_scene of it gives the same scene again.
Json scene_document(const Scene& scene);

/// The size that a document asks for where nothing else says one, or the schema's default.
Viewport document_viewport(const Json& document);

}  // namespace cutaway
