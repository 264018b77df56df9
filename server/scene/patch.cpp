#include <utility>

#include "core/error.h"
#include "scene/json_text.h"
#include "scene/module_aliases.h"
#include "scene/relative_lengths.h"
#include "scene/resolve.h"
#include "scene/scene_fields.h"
#include "scene/schema.h"
#include "scene/schema_node.h"
#include "scene/schema_words.h"

namespace cutaway {

namespace {

bool names_another_module(const Json& old, const Json& patch) {
  const auto name = patch.find("name");
  return name != patch.end() && !name->is_null() && old.contains("name") && old.at("name") != *name;
}

/// RFC 7396, and a module of another name starts empty.
void merge(Json& target, const Json& patch) {
  if (!patch.is_object()) {
    target = patch;
    return;
  }
  if (!target.is_object() || names_another_module(target, patch)) target = Json::object();
  forget_other_lengths(target, patch);
  for (const auto& [key, value] : patch.items()) {
    if (value.is_null())
      target.erase(key);
    else
      merge(target[key], value);
  }
}

/// Merging removes the fields that a patch sets to null, so checking the result would not find a
/// wrong name among them.
void refuse_unknown_nulls(const Json& schema, const Json& patch, const Json& merged,
                          const std::string& pointer) {
  const Json* node = schema.contains("oneOf") ? chosen_branch(schema, merged) : &schema;
  if (node == nullptr || !patch.is_object() || !merged.is_object()) return;
  for (const auto& [key, value] : patch.items()) {
    const Json* field = property(*node, key);
    if (field == nullptr && value.is_null())
      throw Error({.code = ErrorCode::unknown_field,
                   .message = "unknown field",
                   .field = shortened(pointer_to(pointer, key), 200),
                   .expected = words_for_fields(*node)});
    if (field != nullptr && merged.contains(key))
      refuse_unknown_nulls(*field, value, merged.at(key), pointer_to(pointer, key));
  }
}

}  // namespace

Json patch_scene_document(const Json& base, const Json& patch) {
  Json merged = base;
  merge(merged, without_aliases(patch));
  validate_scene_document(merged);
  refuse_unknown_nulls(schema("scene"), patch, merged, "");
  return merged;
}

Json without_volume_choices(Json document) {
  return without_fields(std::move(document), BelongsTo::volume);
}

}  // namespace cutaway
