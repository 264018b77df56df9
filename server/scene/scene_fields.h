// What scene.schema.json says of the scene's fields beside what they may hold. All functions are
// thread-safe.
#pragma once

#include <vector>

#include "scene/json.h"

namespace cutaway {

/// look: how things look; a style says all of it and nothing else. volume: means nothing in another
/// volume. view: how the user looks at any volume. document: of no session.
enum class BelongsTo { look, volume, view, document };

struct SceneField {
  Json::json_pointer pointer;  ///< "/lens/radius_mm"; a module or a list of them is one field
  BelongsTo belongs_to;
};

/// All of them.
const std::vector<SceneField>& scene_fields();

/// What a document says of those fields.
Json only_fields(const Json& document, BelongsTo belongs_to);
Json without_fields(Json document, BelongsTo belongs_to);

/// The parts of a picture's making that the schema names as the only reader of a field.
enum class OnlyReader { composite, slices };

/// Whether nobody else reads what the patch changes.
bool is_read_only_by(OnlyReader reader, const Json& patch);

}  // namespace cutaway
