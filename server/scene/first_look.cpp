#include "scene/first_look.h"

#include <utility>

#include "scene/resolve.h"
#include "scene/scene_fields.h"
#include "scene/styles.h"

namespace cutaway {

Json with_first_look(Json document, const VolumeFacts& volume) {
  const bool is_open = only_fields(document, BelongsTo::look).empty();
  if (!is_open || volume.first_style.empty()) return document;
  document.merge_patch(style(volume.first_style).scene);
  return document;
}

bool has_first_look(const Json& document, const VolumeFacts& volume, Viewport viewport) {
  const Json open = without_fields(document, BelongsTo::look);
  return resolve_scene(with_first_look(open, volume), volume, viewport) ==
         resolve_scene(document, volume, viewport);
}

}  // namespace cutaway
