// Messages as the schema has them, and scenes with fields that the schema knows: of what is changed
// without it, next to nothing gets behind the schema's own check.
#include "fuzz/json_mutator.h"
#include "fuzz/schema_values.h"
#include "scene/schema.h"

namespace cutaway::fuzz {

namespace {

bool has_scene(const Json& message) {
  return message.is_object() && message.contains("scene") && message.at("scene").is_object();
}

}  // namespace

void change(Json& document, Generator& generator) {
  const std::size_t kind = below(generator, 16);
  if (kind == 0) {
    document = value_for(schema("client-message"), generator);
  } else if (kind == 1 && has_scene(document)) {
    document["scene"] = value_for(schema("scene"), generator);
  } else if (kind < 6 && has_scene(document)) {
    document["scene"].merge_patch(field_for(schema("scene"), generator));
  } else {
    change_anywhere(document, generator);
  }
}

}  // namespace cutaway::fuzz
