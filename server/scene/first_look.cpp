#include "scene/first_look.h"

#include <algorithm>
#include <utility>

#include "scene/resolve.h"
#include "scene/scene_fields.h"
#include "scene/styles.h"

namespace cutaway {

namespace {

// Asked at each change of a scene, most of which say all of a look: nothing is built for it.
bool says_a_look(const Json& document) {
  return std::ranges::any_of(scene_fields(), [&document](const SceneField& field) {
    return field.belongs_to == BelongsTo::look && document.contains(field.pointer);
  });
}

}  // namespace

Json with_first_look(Json document, const VolumeFacts& volume) {
  if (volume.first_style.empty() || says_a_look(document)) return document;
  document.merge_patch(style(volume.first_style).scene);
  return document;
}

bool has_first_look(const Json& document, const VolumeFacts& volume, Viewport viewport) {
  const Json open = without_fields(document, BelongsTo::look);
  return resolve_scene(with_first_look(open, volume), volume, viewport) ==
         resolve_scene(document, volume, viewport);
}

}  // namespace cutaway
